#pragma once
#include <cstddef>
#include <functional>

namespace falciform {

/// Calls `job(i)` once for each i in [0, count), begun in ascending order, at most `atOnce` (0: threads()) at
/// a time. Each job stands apart: what it runs with forEachChunk is shared by idle threads, but a thread that
/// waits inside one job never takes up another meanwhile, so that a job's time is its own. After an exception
/// no further job begins, those that run end, and the exception is rethrown here.
void forEachJob(std::size_t count, int atOnce, const std::function<void(std::size_t i)>& job);

}  // namespace falciform
