#pragma once
#include <map>
#include <memory>

#include "Logic/Core/Surface.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/Registration/CoarseAlignment.h"
#include "Logic/Registration/ElasticModes.h"
#include "Logic/Registration/LabelledTarget.h"

namespace falciform {

/// The pre-operative side of a registration, made ready once: long before the scan is there, and for as many
/// scans as come. Immutable; any number of registrations may use one at a time.
class PreparedPreop {
 public:
  /// Throws InputError as checkSurface does, and for fewer than 3 points.
  explicit PreparedPreop(const Surface& preop);

  [[nodiscard]] const Surface& surface() const { return surface_; }
  /// Every label of the surface is in use.
  [[nodiscard]] const LabelledTarget& target() const { return *target_; }
  /// N x 3 unit, outward; zero where a point has no triangle.
  [[nodiscard]] const Points& normals() const { return normals_; }
  /// N values, mm^2; ones for a cloud.
  [[nodiscard]] const VectorXd& areas() const { return areas_; }
  /// By label, mm.
  [[nodiscard]] const std::map<int, Vector3d>& labelCentroids() const { return labelCentroids_; }

  [[nodiscard]] const ElasticModes& modes() const { return modes_; }
  /// A place of the surface and the normal there, as smooth as the points' normals make it.
  struct Place {
    Vector3d point, normal;
    int triangle = -1;  ///< that holds it; -1: a point without triangles
  };
  /// The place nearest to `query` on the triangles around point `near`: the surface's own where `near` is the
  /// nearest point and triangles are not slivers.
  [[nodiscard]] Place placeAround(int near, const Vector3d& query) const;
  /// The place nearest to `query` as a walk over the surface finds it from `last`, which was nearest to a
  /// query close by: first on the triangle of `last`, then around one corner after another. `near` becomes
  /// the corner that the place is at.
  [[nodiscard]] Place placeByWalk(const Place& last, int& near, const Vector3d& query) const;
  [[nodiscard]] const CoarseTarget& coarse() const { return coarse_; }
  /// Rows that stand for the surface, spread at random, where a share or a mean need not be exact.
  [[nodiscard]] const std::vector<int>& sample() const { return sample_; }

 private:
  struct Hit;
  [[nodiscard]] Hit hitOn(int triangle, const Vector3d& query) const;
  [[nodiscard]] Hit hitAround(int near, const Vector3d& query) const;
  [[nodiscard]] int cornerAt(const Hit& hit) const;
  [[nodiscard]] Place placeOf(const Hit& hit, int near) const;

  Surface surface_;
  Points normals_;
  VectorXd areas_;
  std::map<int, Vector3d> labelCentroids_;
  // Points, normals and triangles again, each whole in one place: a nearest place reads a few, far apart.
  template <class Scalar>
  using Packed = Eigen::Matrix<Scalar, Eigen::Dynamic, 3, Eigen::RowMajor>;
  Packed<double> packedPoints_, packedNormals_;
  Packed<int> packedTriangles_;
  std::vector<char> slivers_;  ///< of each triangle, whether it is one
  Adjacency trianglesAround_;
  ElasticModes modes_;
  std::vector<int> sample_;
  CoarseTarget coarse_;
  std::shared_ptr<const LabelledTarget> target_;
};

}  // namespace falciform
