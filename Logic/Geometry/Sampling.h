#pragma once
#include <cstdint>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// At most one point (the first by index nearest the cell's centre) of each cubic cell of `cellMm`; ids
/// ascending.
[[nodiscard]] std::vector<int> voxelSample(const Points& points, double cellMm);
/// About `count` ids spread evenly over space: voxelSample with the cell found by bisection; all ids if there
/// are fewer.
[[nodiscard]] std::vector<int> spreadSample(const Points& points, Index count);
/// Rows `ids` of `points`.
[[nodiscard]] Points rowsOf(const Points& points, const std::vector<int>& ids);

}  // namespace falciform
