#pragma once
#include <array>
#include <cstddef>

#include "Logic/Core/Volume.h"

namespace falciform {

/// How a stored grid is walked so that its axes run nearest to L, P, S: the voxel (i, j, k) of the turned
/// grid is stored at `first + i step[0] + j step[1] + k step[2]`.
struct StorageOrder {
  Vector3i size = Vector3i::Zero();                ///< of the turned grid
  Matrix4d worldFromIndex = Matrix4d::Identity();  ///< of the turned grid
  std::ptrdiff_t first = 0;
  std::array<std::ptrdiff_t, 3> step{1, 0, 0};

  [[nodiscard]] std::size_t offset(int i, int j, int k) const {
    return static_cast<std::size_t>(first + i * step[0] + j * step[1] + k * step[2]);
  }
};

/// The pairing of axes whose directions agree best with L, P, S in sum, which stays well defined for oblique
/// grids where two axes may lean to the same world axis.
[[nodiscard]] StorageOrder canonicalOrder(const Vector3i& size, const Matrix4d& worldFromIndex);

}  // namespace falciform
