#pragma once
#include <memory>
#include <vector>

#include "Logic/Core/Surface.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {

/// A surface made ready for the brush: what one dab touches is found in a time that grows with the dab alone.
class BrushSurface {
 public:
  explicit BrushSurface(const Surface& surface);

  /// True if `surface` has the points and triangles this was made from.
  [[nodiscard]] bool madeFrom(const Surface& surface) const;

  /// Vertices within `radius` mm of `hit` on `triangle`, along the surface and connected to it. With a
  /// `viewDirection`, only those that face the camera as the hit triangle does: so a sheet seen from behind
  /// can be painted, its far side cannot. Clouds (`triangle` -1): from the point nearest to `hit`, over steps
  /// of at most 3 mean spacings.
  [[nodiscard]] std::vector<int> under(int triangle, const Vector3d& hit, const Vector3d& viewDirection,
                                       double radius) const;

  [[nodiscard]] const Surface& shape() const { return shape_; }  ///< points, triangles and normals alone
  [[nodiscard]] bool isCloud() const { return shape_.triangles.rows() == 0; }
  /// The points joined to `point`: by an edge or, on a cloud, closer than 3 mean spacings. Some may stand
  /// twice.
  void neighbours(int point, std::vector<int>& result) const;
  /// Points within `radius` mm of any of `seeds`, these included, ascending: along the surface on a mesh,
  /// straight on a cloud.
  [[nodiscard]] std::vector<int> around(const std::vector<int>& seeds, double radius) const;
  /// What share of the surface each point stands for: mm^2, or 1 on a cloud.
  [[nodiscard]] const VectorXd& weights() const { return weights_; }
  /// Points on the open border of a mesh; all 0 on a cloud.
  [[nodiscard]] const std::vector<char>& onBorder() const { return onBorder_; }

 private:
  [[nodiscard]] std::vector<int> underOnMesh(int triangle, const Vector3d& hit, const Vector3d& view,
                                             double radius) const;
  [[nodiscard]] std::vector<int> underOnCloud(const Vector3d& hit, const Vector3d& view, double radius) const;

  Surface shape_;
  VectorXd weights_;
  std::vector<char> onBorder_;
  Adjacency trianglesOfVertex_;
  KdTree tree_;      ///< of a cloud
  double link_ = 0;  ///< mm, of a cloud
};

}  // namespace falciform
