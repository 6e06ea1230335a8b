#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform {

/// One side of one lobe, and what error is to be expected there.
struct RegionExpectation {
  std::string name;      ///< "the back of the right lobe"
  double areaShare = 0;  ///< of the surface
  double meanMm = 0;     ///< area-weighted
};

/// Expected errors (N, mm) over a liver's surface in patient LPS, by lobe and side, the largest mean first.
/// Lobes are parted at the middle of the falciform patch, or, where none is painted, a third of the liver's
/// width from its left end; a side is where the surface looks. Regions below 3 % of the area are left out.
/// Throws InputError for another number of errors than points.
[[nodiscard]] std::vector<RegionExpectation> expectationByRegion(const Surface& liver,
                                                                 const VectorXd& expectedMm);

}  // namespace falciform
