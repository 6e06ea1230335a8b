#pragma once
#include <vector>

#include "Logic/Geometry/TriangleTree.h"
#include "Logic/Patches/BrushSurface.h"

namespace falciform {

/// A place on a surface.
struct SurfacePlace {
  int triangle = -1;  ///< -1 on a cloud
  int vertex = -1;    ///< the nearest
  Vector3d point = Vector3d::Zero();
};

/// The shortest way from one place to another along the surface, both ends included; empty where there is
/// none. First over edges (A*: Hart, Nilsson, Raphael 1968; on a cloud from neighbour to neighbour), then, on
/// a mesh and without `cost`, pulled taut on the surface, so that it does not depend on how the mesh is cut.
/// With `cost` (one value above 0 a point) lengths are multiplied by it, and the way runs where it is cheap:
/// along a ridge, say. `tree`, of the same surface, may be nullptr for a cloud only.
[[nodiscard]] std::vector<SurfacePlace> shortestPath(const BrushSurface& surface, const TriangleTree* tree,
                                                     const SurfacePlace& from, const SurfacePlace& to,
                                                     const VectorXd& cost = {});

/// Length of a path, mm.
[[nodiscard]] double lengthOf(const std::vector<SurfacePlace>& path);

/// Points within `halfWidth` mm of the path along the surface, ascending.
[[nodiscard]] std::vector<int> pointsAlong(const BrushSurface& surface, const std::vector<SurfacePlace>& path,
                                           double halfWidth);

}  // namespace falciform
