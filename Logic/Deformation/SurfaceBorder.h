#pragma once
#include <array>
#include <limits>
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

/// Where a cloud of points ends: its border and its holes are not drawn, and are judged by its spacing.
class CloudBorder {
 public:
  /// `cloud` is a tree over all rows of `points`; both must outlive this.
  CloudBorder(const KdTree& cloud, const Points& points);

  /// True if `query`, a vertex of a surface with `normal`, lies past the border at `nearest`, the point
  /// nearest to it: seen along the normal it is more than half a spacing aside of the point, and within three
  /// spacings of that one no point lies in its direction, 45 deg to either hand.
  [[nodiscard]] bool isPassed(const Vector3d& query, const Vector3d& normal, int nearest) const;

  /// Mean distance to the six nearest points, at most 1.5 times its median: stragglers farther apart do not
  /// cover what is between.
  [[nodiscard]] double spacingAt(int point) const;

 private:
  const KdTree& cloud_;
  const Points& points_;
  double largest_ = std::numeric_limits<double>::infinity();  ///< mm
};

}  // namespace falciform
