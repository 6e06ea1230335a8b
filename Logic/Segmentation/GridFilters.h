#pragma once
#include <cstdint>
#include <vector>

#include "Logic/Core/Volume.h"

namespace falciform {

/// Filters of the segmentation's grids: separable, each line on its own, so that no result depends on the
/// number of threads. Beyond the border the nearest voxel is repeated.

/// Gaussian of `sigmaMm` in every direction, cut off at 3 sigma.
void smooth(Image& image, double sigmaMm);

/// Sum over the box of +-`half` voxels (those inside the grid).
void sumOverBox(Image& image, const Vector3i& half);

/// Euclidean distance, mm, from each voxel's centre to the nearest centre whose flag is set; infinity if none
/// is (Felzenszwalb and Huttenlocher, exact).
[[nodiscard]] Image distanceTo(const Volume<std::uint8_t>& flags);
/// The same to the nearest centre whose flag is not set: how deep each voxel lies.
[[nodiscard]] Image depthWithin(const Volume<std::uint8_t>& flags);

/// An image of the same grid as `like`, all `value`.
template <class T, class U>
[[nodiscard]] Volume<T> sameGrid(const Volume<U>& like, T value) {
  return {like.size, like.worldFromIndex, std::vector<T>(like.voxels.size(), value)};
}

}  // namespace falciform
