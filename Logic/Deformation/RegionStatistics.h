#pragma once
#include "Logic/Core/Results.h"

namespace falciform {

/// Figures of one side of a distance map, from the arrays it carries: of all, of each patch, and of each
/// segment if it has an array `couinaud_segment`. Values that are NaN enter no mean.
[[nodiscard]] std::vector<RegionFigures> regionStatistics(const Surface& side);

/// "segment IV" of 4; "segment 12" of what is not Couinaud's.
[[nodiscard]] std::string segmentName(int segment);

}  // namespace falciform
