#pragma once
#include <algorithm>
#include <vector>

namespace falciform {

/// The median (the upper one of an even number; 0 of none). The order of `values` is changed.
template <class T>
[[nodiscard]] T medianInPlace(std::vector<T>& values) {
  if (values.empty()) return T{};
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace falciform
