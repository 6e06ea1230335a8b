#pragma once
#include <cstdint>
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform {

/// The points of a scan that a fit works with.
struct ScanChoice {
  Points points;            ///< K x 3, scan mm
  std::vector<int> labels;  ///< K patch labels
  Points crowd;             ///< up to 4 K x 3, the chosen ones first: enough to tell what is seen
};

/// At most `count` points, drawn at random by `seed`, without stragglers (smoke, threads, strewn noise): the
/// same for every method, so that methods are compared and not their sight. Throws InputError for fewer than
/// 10 that are left.
[[nodiscard]] ScanChoice chooseScanPoints(const Surface& scan, int count, std::uint64_t seed);

}  // namespace falciform
