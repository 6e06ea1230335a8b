#include "Widgets/Rendering/ScanView.h"

#include <Eigen/Eigenvalues>
#include <vector>

namespace falciform {

namespace {

/// Principal axes as columns, thinnest first.
Matrix3d principalAxes(const Points& points) {
  const Points centred = points.rowwise() - points.colwise().mean();
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(centred.transpose() * centred).eigenvectors();
}

}  // namespace

Vector3d uprightFor(const Surface& scan, const Vector3d& view) {
  Vector3d along = scan.size() < 3 ? Vector3d::UnitX() : Vector3d(principalAxes(scan.points).col(2));
  along -= along.dot(view) * view;
  if (along.norm() < 1e-6) along = view.unitOrthogonal();
  const Vector3d up = view.cross(along).normalized();
  // The inferior ridge belongs below.
  const std::vector<int> ridge = pointsOfPatch(scan, patch::kInferiorRidge);
  Vector3d ridgeCentre = Vector3d::Zero();
  for (const int i : ridge) ridgeCentre += scan.points.row(i).transpose() / static_cast<double>(ridge.size());
  const Vector3d centre =
      scan.size() > 0 ? Vector3d(scan.points.colwise().mean().transpose()) : Vector3d::Zero();
  return !ridge.empty() && (ridgeCentre - centre).dot(up) > 0 ? Vector3d(-up) : up;
}

}  // namespace falciform
