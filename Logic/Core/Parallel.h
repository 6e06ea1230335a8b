#pragma once
#include <cstddef>
#include <functional>

namespace falciform {

/// Number of threads that forEachChunk may use from now on, at least 1; 0 = all cores.
void setThreads(int count);
[[nodiscard]] int threads();

/// Calls `body(begin, end)` for [0, count) cut into chunks of `chunk` items, on up to threads() threads. The
/// cut depends on `count` and `chunk` alone, so a result assembled chunk by chunk does not depend on the
/// number of threads. An exception from a body is rethrown here.
void forEachChunk(std::size_t count, std::size_t chunk,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

}  // namespace falciform
