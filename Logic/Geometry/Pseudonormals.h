#pragma once
#include <array>
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform {

/// Normals whose sign tells inside from outside at every kind of closest place (Baerentzen, Aanaes 2005).
/// Vertices in the same place count as one, so that a surface stored triangle by triangle has edges too.
struct Pseudonormals {
  Points face;  ///< M x 3, unit; zero for a triangle without area
  std::vector<std::array<Vector3d, 3>>
      edge;       ///< per triangle ab, bc, ca: sum of the unit normals of the edge's triangles
  Points corner;  ///< N x 3: sum of unit normals weighted by the angle at the vertex
};

/// Unit normal of the triangle abc, on the side from which it is seen counter-clockwise; zero without area.
[[nodiscard]] Vector3d faceNormal(const Vector3d& a, const Vector3d& b, const Vector3d& c);

[[nodiscard]] Pseudonormals pseudonormals(const Points& points, const Triangles& triangles);

}  // namespace falciform
