#pragma once
#include <vector>

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
/// (median of the third layer), where it exceeds these by four of their standard deviations. As a voxel's
/// value is its share of the body (partial volume), the centre is not drawn to the grid; exact where voxels
/// weigh what they see linearly. Nothing else may lie within three voxels. Throws InputError if the seed lies
/// outside the volume or below the threshold, or the region outgrows `largestMm3`.
[[nodiscard]] GrownRegion growRegion(const Image& image, const Vector3d& seed, double threshold,
                                     double largestMm3);

/// All bodies of voxels of at least `threshold` joined through faces whose voxels at or above it are between
/// `smallestMm3` and `largestMm3`, with their centres as above, in the order of their first voxels: markers
/// and beads as Wang et al. 1996 look for them, by brightness and size first and by the weighted centre then.
[[nodiscard]] std::vector<GrownRegion> findBodies(const Image& image, double threshold, double smallestMm3,
                                                  double largestMm3);

}  // namespace falciform
