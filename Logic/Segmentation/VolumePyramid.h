#pragma once
#include <vector>

#include "Logic/Segmentation/StorageOrder.h"

namespace falciform {

/// A box of a stored volume on the axes of canonicalOrder, coarsened by whole factors: each voxel is the mean
/// of a block. Block (0, 0, 0) begins at the turned index `origin`.
struct PyramidLevel {
  Vector3i factor = Vector3i::Ones(), origin = Vector3i::Zero();
  Image image;

  /// Continuous index in this level of a continuous turned index of the stored volume, and back.
  [[nodiscard]] Vector3d fromStored(const Vector3d& index) const {
    return ((index - origin.cast<double>()).array() + 0.5) / factor.cast<double>().array() - 0.5;
  }
  [[nodiscard]] Vector3d toStored(const Vector3d& index) const {
    return ((index.array() + 0.5) * factor.cast<double>().array() - 0.5).matrix() + origin.cast<double>();
  }
};

/// Factors from coarse to fine (the last is 1, 1, 1): each level about twice as fine as the one before, its
/// voxels as near to cubes as whole factors allow, the coarsest near but not above `coarsestMm`.
[[nodiscard]] std::vector<Vector3i> pyramidFactors(const Vector3d& spacing, double coarsestMm);

/// The level with this factor over the turned indices low..high. Beyond the volume its nearest voxels are
/// repeated; voxels that are no number count as -1024 HU, air.
[[nodiscard]] PyramidLevel coarsened(const Image& ct, const StorageOrder& order, const Vector3i& factor,
                                     const Vector3i& low, const Vector3i& high);

/// The same for flags: the share of each block whose stored value is above 0; none beyond the volume.
[[nodiscard]] Image coarsenedShare(const LabelMap& map, const StorageOrder& order, const PyramidLevel& like);

/// `image` of the level `from`, at the voxels of the level `to`; where `skip` (on `to`'s grid) is set, 0.
[[nodiscard]] Image resampled(const Image& image, const PyramidLevel& from, const PyramidLevel& to,
                              const Volume<std::uint8_t>* skip = nullptr);

/// The value at a continuous index, linear between voxels, the nearest beyond the border.
[[nodiscard]] float valueAt(const Image& image, const Vector3d& index);

}  // namespace falciform
