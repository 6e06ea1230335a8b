#pragma once
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {

/// `count` points at `radiusMm` along the surface from `centre` on `triangle`: the border of what a brush
/// covers. Each is reached by short steps that stay on the surface; at an open border the ring runs along it.
[[nodiscard]] Points geodesicRing(const TriangleTree& tree, int triangle, const Vector3d& centre,
                                  double radiusMm, int count = 48);

/// A circle across `viewDirection`, for clouds.
[[nodiscard]] Points flatRing(const Vector3d& centre, const Vector3d& viewDirection, double radiusMm,
                              int count = 48);

}  // namespace falciform
