#pragma once
#include <cstddef>
#include <memory>

namespace falciform {

struct FreeMemory {
  void operator()(void* data) const;
};

/// Numbers that nothing is written to yet.
template <class Number>
using LargeArray = std::unique_ptr<Number[], FreeMemory>;

/// Memory on large pages where the system has them: the first touch of half a gigabyte on small ones takes as
/// long as the arithmetic on it.
[[nodiscard]] void* allocateLarge(std::size_t bytes);

template <class Number>
[[nodiscard]] LargeArray<Number> largeArray(std::size_t count) {
  return LargeArray<Number>(static_cast<Number*>(allocateLarge(count * sizeof(Number))));
}

}  // namespace falciform
