#pragma once
#include <cstdint>

#include "Logic/Core/Surface.h"

namespace falciform::bench {

/// Makes `share` of the labelled points wrong, patch by patch. Half of these are one piece in the wrong
/// place: one end of the patch loses its label, and a patch of as many points at least 40 mm off gets it. The
/// other half are strewn: points that carry the label of the other patch instead.
[[nodiscard]] Surface withWrongLabels(const Surface& scan, double share, std::uint64_t seed);

/// Adds unlabelled points until they are `share` of all: half strewn evenly in the scan's box and 20 mm
/// around it, half on a sheet of 80 x 30 mm, as of a retractor, that stands on the scan at a random place and
/// angle.
[[nodiscard]] Surface withOutliers(const Surface& scan, double share, std::uint64_t seed);

}  // namespace falciform::bench
