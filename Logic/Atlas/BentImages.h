#pragma once
#include "Logic/Atlas/UpdateMap.h"
#include "Logic/Core/Progress.h"
#include "Logic/Core/Volume.h"

namespace falciform {

/// The backward displacements of a model update on a grid in the pre-op frame: at a voxel's centre x, in bent
/// coordinates, the vector that leads to where it was: preop = x + vector. So an image on that grid is bent
/// by resampling, and 3D Slicer, which reads grid transforms in that direction, moves whatever it is applied
/// to from where it was to where it is, rigid motion apart. Vectors are exact to 1e-4 mm and fade to 0 over
/// the map's margin. The same for any number of threads.
[[nodiscard]] DisplacementGrid sampleDisplacements(const UpdateMap& map, const Vector3i& size,
                                                   const Matrix4d& worldFromIndex,
                                                   const Progress& progress = {});

/// The volume's voxels about `spacingMm` apart, so that first and last corner stay where they are or move
/// outwards; 0: as they are. What displacements are sampled on.
struct SampledGrid {
  Vector3i size = Vector3i::Zero();
  Matrix4d worldFromIndex = Matrix4d::Identity();
};
[[nodiscard]] SampledGrid coarserGrid(const Vector3i& size, const Matrix4d& worldFromIndex, double spacingMm);

/// The volume's grid, with whole voxels added on the sides where the bent mesh sticks out.
[[nodiscard]] SampledGrid gridAroundLiver(const UpdateMap& map, const Vector3i& size,
                                          const Matrix4d& worldFromIndex);

/// The CT as it would look now, in bent coordinates, on gridAroundLiver: trilinear; `background` where the CT
/// does not reach. Voxels in the liver are mapped exactly, those around it by displacements on a grid of 3
/// mm. With scanFromPreop * worldFromIndex for its grid it lies in the scan's frame: nothing is resampled
/// twice.
[[nodiscard]] Image bendImage(const UpdateMap& map, const Image& ct, float background,
                              const Progress& progress = {});
/// The same for labels: each voxel takes the label of the nearest voxel of where it was, 0 beyond the map.
[[nodiscard]] LabelMap bendLabels(const UpdateMap& map, const LabelMap& labels,
                                  const Progress& progress = {});

/// The value that stands for nothing in a CT: its smallest.
[[nodiscard]] float backgroundOf(const Image& ct);

/// The same voxels, moved rigidly: only the grid's place changes.
template <class T>
[[nodiscard]] Volume<T> movedVolume(Volume<T> volume, const Isometry3d& motion) {
  volume.worldFromIndex = motion.matrix() * volume.worldFromIndex;
  return volume;
}

}  // namespace falciform
