#pragma once
#include <cstdint>
#include <functional>

#include "Logic/Core/Volume.h"

namespace falciform::test {

/// A CT of `size` voxels of `spacingMm`, axes along LPS, first voxel at 0: `hu(place in mm)` at each voxel's
/// centre and Gaussian noise.
[[nodiscard]] Image paintedCt(const Vector3i& size, const Vector3d& spacingMm, double noiseHu,
                              std::uint64_t seed, const std::function<double(const Vector3d&)>& hu);

/// The same volume stored with its axes flipped and permuted: world positions are unchanged.
template <class T>
[[nodiscard]] Volume<T> storedOtherwise(const Volume<T>& volume) {
  // New axes: k backwards, i, j backwards.
  Volume<T> other;
  other.size = {volume.size.z(), volume.size.x(), volume.size.y()};
  const Vector3d first(0, volume.size.y() - 1, volume.size.z() - 1);
  other.worldFromIndex.col(0) = -volume.worldFromIndex.col(2);
  other.worldFromIndex.col(1) = volume.worldFromIndex.col(0);
  other.worldFromIndex.col(2) = -volume.worldFromIndex.col(1);
  other.worldFromIndex.col(3) = volume.worldFromIndex * first.homogeneous();
  other.voxels.reserve(volume.voxels.size());
  for (int j = volume.size.y() - 1; j >= 0; --j)
    for (int i = 0; i < volume.size.x(); ++i)
      for (int k = volume.size.z() - 1; k >= 0; --k) other.voxels.push_back(volume.at(i, j, k));
  return other;
}

/// 2 |A and B| / (|A| + |B|) of the voxels above 0.
[[nodiscard]] double dice(const LabelMap& a, const LabelMap& b);

}  // namespace falciform::test
