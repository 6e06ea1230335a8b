#pragma once
#include "Logic/Core/Surface.h"
#include "Logic/Segmentation/Mask.h"

namespace falciform {

/// How good a surface is beside the mask that it was made of.
struct SurfaceQuality {
  Index crossings = 0;  ///< pairs of triangles that cut through each other
  double meanEdgeMm = 0;
  /// Distances between the surface and the steps of the voxels, both ways: from the middle of each voxel face
  /// between organ and background to the surface, and from each vertex to the nearest such face. A good
  /// smooth surface has a mean of 0.1 to 0.25 voxels.
  double meanMm = 0, p95Mm = 0, maxMm = 0;
};

/// `mask` has background all around, as cutOut gives it. Throws InputError if either is empty.
[[nodiscard]] SurfaceQuality measureQuality(const Surface& surface, const Mask& mask);

}  // namespace falciform
