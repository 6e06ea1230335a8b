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

 private:
  [[nodiscard]] std::vector<int> underOnMesh(int triangle, const Vector3d& hit, const Vector3d& view,
                                             double radius) const;
  [[nodiscard]] std::vector<int> underOnCloud(const Vector3d& hit, const Vector3d& view, double radius) const;

  Surface shape_;  ///< points, triangles and normals alone
  Adjacency trianglesOfVertex_;
  KdTree tree_;      ///< of a cloud
  double link_ = 0;  ///< mm, of a cloud
};

}  // namespace falciform
