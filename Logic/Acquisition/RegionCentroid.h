#pragma once
#include "Logic/Core/Volume.h"

namespace falciform {

/// A bright body in a volume.
struct GrownRegion {
  Vector3d centre = Vector3d::Zero();  ///< centre of mass, LPS mm
  double volumeMm3 = 0;                ///< with shares of the voxels at its border
  std::size_t voxels = 0;              ///< at or above the threshold
};

/// The body around `seed` (LPS mm): voxels of at least `threshold` joined through faces, grown from the voxel
/// at the seed; and its centre, each voxel within two layers weighted by its value above the surroundings'
/// (median of the third layer). As a voxel's value is its share of the body (partial volume), the centre
/// is not drawn to the grid; exact where voxels weigh what they see linearly. Nothing else may lie within
/// three voxels. Throws InputError if the seed lies outside the volume or below the threshold, or the region
/// outgrows `largestMm3`.
[[nodiscard]] GrownRegion growRegion(const Image& image, const Vector3d& seed, double threshold,
                                     double largestMm3);

}  // namespace falciform
