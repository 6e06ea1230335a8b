#pragma once
#include <cstdint>
#include <vector>

#include "Logic/Core/Volume.h"

namespace falciform {

/// A 26-connected piece of flagged voxels.
struct RegionPiece {
  std::vector<std::size_t> voxels;     ///< ascending
  Vector3d middle = Vector3d::Zero();  ///< mean index

  [[nodiscard]] double volumeMl(const Volume<std::uint8_t>& grid) const {
    return static_cast<double>(voxels.size()) * grid.voxelVolume() / 1000;
  }
};

/// In the order of their first voxel.
[[nodiscard]] std::vector<RegionPiece> piecesOf(const Volume<std::uint8_t>& flags);

/// Calls `visit(offset)` for the up to six neighbours of a voxel.
template <class Visit>
void eachFaceNeighbour(const Vector3i& size, std::size_t at, Visit&& visit) {
  const auto row = static_cast<std::size_t>(size.x()), slice = row * static_cast<std::size_t>(size.y());
  const std::size_t x = at % row, y = at / row % static_cast<std::size_t>(size.y()), z = at / slice;
  if (x > 0) visit(at - 1);
  if (x + 1 < row) visit(at + 1);
  if (y > 0) visit(at - row);
  if (y + 1 < static_cast<std::size_t>(size.y())) visit(at + row);
  if (z > 0) visit(at - slice);
  if (z + 1 < static_cast<std::size_t>(size.z())) visit(at + slice);
}

}  // namespace falciform
