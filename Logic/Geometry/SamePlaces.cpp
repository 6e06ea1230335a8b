#include "Logic/Geometry/SamePlaces.h"

#include <cstdint>
#include <cstring>

namespace falciform {

std::vector<int> firstInSamePlace(const Points& points) {
  const auto n = static_cast<std::size_t>(points.rows());
  std::size_t size = 16;
  while (size < 2 * n) size *= 2;
  std::vector<int> table(size, -1), first(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3d p = points.row(static_cast<Index>(i)).transpose().array() + 0.0;  // -0 and 0 are one place
    std::uint64_t hash = 0, bits = 0;
    for (int axis = 0; axis < 3; ++axis) {
      std::memcpy(&bits, &p[axis], sizeof bits);
      hash = (hash ^ bits) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 29;
    }
    std::size_t slot = hash & (size - 1);
    while (table[slot] >= 0 && points.row(table[slot]) != points.row(static_cast<Index>(i)))
      slot = (slot + 1) & (size - 1);
    if (table[slot] < 0) table[slot] = static_cast<int>(i);
    first[i] = table[slot];
  }
  return first;
}

}  // namespace falciform
