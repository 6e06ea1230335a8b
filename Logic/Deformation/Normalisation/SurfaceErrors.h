#pragma once
#include "Logic/Core/Surface.h"
#include "Logic/Deformation/Normalisation/LiverMap.h"

namespace falciform {

/// How well two livers' surfaces lie on each other after the source was brought into the target's frame, as
/// in thesis Table IV.3: closest-point distances, mm, not signed. They say nothing about motion along the
/// surface.
struct SurfaceErrors {
  Surface moved;            ///< the source's surface in the target's frame
  VectorXd sourceToTarget;  ///< at each source vertex: from where it came to lie to the target's surface
  VectorXd targetToSource;  ///< at each target vertex: to the moved surface
};

/// Both surfaces with triangles.
[[nodiscard]] SurfaceErrors surfaceErrors(const Surface& target, const Surface& source, const LiverMap& map);

}  // namespace falciform
