#pragma once
#include <functional>
#include <vector>

#include "Logic/Core/Surface.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {

struct GeodesicPoint {
  int vertex = -1;
  double distance = 0;  ///< mm along the surface
};

/// Vertices within `radius` mm of `seed` along the surface, connected to it, nearest first. Fast marching on
/// the triangles: exact on planes, over edges only where a triangle is obtuse. `seed` is a place on triangle
/// `seedTriangle` (start distances run straight to its corners). Only vertices for which `allowed` is not 0
/// (empty = all) are entered.
[[nodiscard]] std::vector<GeodesicPoint> withinGeodesicRadius(const Surface& surface,
                                                              const Adjacency& trianglesOfVertex,
                                                              int seedTriangle, const Vector3d& seed,
                                                              double radius,
                                                              const std::vector<char>& allowed = {});

/// The same with a question in place of a list: the work grows with the vertices within the radius, not with
/// the surface.
[[nodiscard]] std::vector<GeodesicPoint> withinGeodesicRadius(const Surface& surface,
                                                              const Adjacency& trianglesOfVertex,
                                                              int seedTriangle, const Vector3d& seed,
                                                              double radius,
                                                              const std::function<bool(int)>& isAllowed);

/// Vertices within `radius` mm of the nearest of the vertices `seeds` along the surface, these included,
/// nearest first. Exact to about an edge's length beside the seeds, as the border between vertices is not
/// known better.
[[nodiscard]] std::vector<GeodesicPoint> withinGeodesicRadius(const Surface& surface,
                                                              const Adjacency& trianglesOfVertex,
                                                              const std::vector<int>& seeds, double radius);

}  // namespace falciform
