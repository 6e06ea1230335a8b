#pragma once
#include <cstdint>
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform {

/// The points of a scan that a fit works with.
struct ScanChoice {
  Points points;            ///< K x 3, scan mm
  std::vector<int> labels;  ///< K patch labels
};

/// At most `count` points, drawn at random by `seed`, without stragglers (smoke, threads, strewn noise): the
/// same for every method, so that methods are compared and not their sight. Throws InputError for fewer than
/// 10 that are left.
[[nodiscard]] ScanChoice chooseScanPoints(const Surface& scan, int count, std::uint64_t seed);

}  // namespace falciform
