#pragma once
#include <cstdint>
#include <vector>

#include "Logic/Atlas/BentImages.h"

namespace falciform {

/// Which cells of a grid the deformed mesh may touch: elsewhere no element need be looked for.
class BentBlocks {
 public:
  BentBlocks(const UpdateMap& map, const SampledGrid& grid);

  /// `index`: a place in the grid's voxel coordinates.
  [[nodiscard]] bool mayHold(const Vector3d& index) const {
    const Vector3i cell = index.array().floor().cast<int>();
    return (cell.array() >= 0).all() && (cell.array() < size_.array()).all() && cells_[offset(cell)] != 0;
  }

 private:
  [[nodiscard]] std::size_t offset(const Vector3i& cell) const {
    return (static_cast<std::size_t>(cell.z()) * static_cast<std::size_t>(size_.y()) +
            static_cast<std::size_t>(cell.y())) *
               static_cast<std::size_t>(size_.x()) +
           static_cast<std::size_t>(cell.x());
  }

  Vector3i size_;
  std::vector<std::uint8_t> cells_;
};

}  // namespace falciform
