#pragma once
#include <array>
#include <vector>

#include "Logic/Core/Surface.h"
#include "Logic/Geometry/KdTree.h"

namespace falciform {

/// The border of an open triangle surface: edges of one triangle.
class SurfaceBorder {
 public:
  explicit SurfaceBorder(const Surface& surface);

  [[nodiscard]] bool empty() const { return empty_; }
  /// True if the place (barycentric weights on a triangle) lies on a border edge or at a border vertex.
  [[nodiscard]] bool holds(int triangle, const Vector3d& barycentric) const;

 private:
  bool empty_ = true;
  std::vector<std::array<char, 3>> edge_;    ///< per triangle: is ab, bc, ca on the border
  std::vector<std::array<char, 3>> corner_;  ///< per triangle: is a, b, c on the border
};

/// True if a way of `offset` runs so far aside of both normals (unit; zero: not known) that it leads past a
/// border rather than from one surface to the other: more than 15 deg, which bounds the error of a distance
/// taken there to 3.5 %.
[[nodiscard]] bool leadsAside(const Vector3d& offset, const Vector3d& normal, const Vector3d& otherNormal);

/// True if a cloud lies all on one side of `query`, seen along `normal`: the points about the nearest one
/// leave a half-plane free. Not asked within half a local spacing of the nearest point `nearest`, mm.
[[nodiscard]] bool beyondCloud(const KdTree& cloud, const Points& points, int nearest, const Vector3d& query,
                               const Vector3d& normal);

}  // namespace falciform
