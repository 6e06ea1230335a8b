#pragma once
#include <cstddef>
#include <vector>

#include "Logic/Core/Volume.h"

namespace falciform {

/// Offsets of the voxels of a grid whose centres lie within `radiusMm` of `place` (LPS mm), ascending, and of
/// the voxel that holds the place; none if the place lies outside the grid.
[[nodiscard]] std::vector<std::size_t> voxelsInBall(const LabelMap& grid, const Vector3d& place,
                                                    double radiusMm);

/// What one voxel of an edited map was.
struct VoxelChange {
  std::size_t voxel = 0;
  std::uint16_t label = 0;
  bool forbidden = false;
};

}  // namespace falciform
