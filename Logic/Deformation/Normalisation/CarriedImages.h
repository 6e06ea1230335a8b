#pragma once
#include "Logic/Core/Progress.h"
#include "Logic/Core/Volume.h"
#include "Logic/Deformation/Normalisation/LiverMap.h"

namespace falciform {

/// The map on a grid in the target's frame: at a voxel's centre the vector that leads from there to its place
/// in the source. So the source's images are brought onto the target by resampling; a grid transform of 3D
/// Slicer and ITK.
[[nodiscard]] DisplacementGrid sampleDisplacements(const LiverMap& map, const Vector3i& size,
                                                   const Matrix4d& worldFromIndex,
                                                   const Progress& progress = {});

/// The source patient's image on the target's grid, trilinear; `background` where it does not reach. Places
/// come from displacements between the corners of `carrier`.
[[nodiscard]] Image carryImage(const DisplacementGrid& carrier, const Image& source, float background,
                               const Vector3i& size, const Matrix4d& worldFromIndex);
/// The same for labels: the nearest voxel's, 0 beyond.
[[nodiscard]] LabelMap carryLabels(const DisplacementGrid& carrier, const LabelMap& source,
                                   const Vector3i& size, const Matrix4d& worldFromIndex);

}  // namespace falciform
