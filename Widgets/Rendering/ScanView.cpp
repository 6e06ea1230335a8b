#include "Widgets/Rendering/ScanView.h"

#include <Eigen/Eigenvalues>

#include "Logic/Geometry/Measures.h"

namespace falciform {

namespace {

/// Principal axes as columns, thinnest first.
Matrix3d principalAxes(const Points& points) {
  const Points centred = points.rowwise() - points.colwise().mean();
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(centred.transpose() * centred).eigenvectors();
}

}  // namespace

Vector3d seenFrom(const Surface& scan) {
  if (scan.size() < 3) return Vector3d::UnitZ();
  Vector3d sum = Vector3d::Zero();
  for (Index t = 0; t < scan.triangles.rows(); ++t) {
    const Vector3d a = scan.points.row(scan.triangles(t, 0)), b = scan.points.row(scan.triangles(t, 1)),
                   c = scan.points.row(scan.triangles(t, 2));
    sum += (b - a).cross(c - a);
  }
  // A closed surface has no mean normal; what little is left of it is rounding.
  if (sum.norm() > 0.02 * 2 * area(scan) && scan.triangles.rows() > 0) return sum.normalized();

  const Vector3d thin = principalAxes(scan.points).col(0);
  const Points centred = scan.points.rowwise() - scan.points.colwise().mean();
  const VectorXd height = centred * thin;
  const VectorXd rim = (centred - height * thin.transpose()).rowwise().squaredNorm();
  // Organs bulge towards the scanner: where the rim lies lower than the middle, the axis points at the
  // scanner.
  const double falls = (height.array() * (rim.array() - rim.mean())).sum();
  return falls > 0 ? Vector3d(-thin) : thin;
}

Vector3d uprightFor(const Surface& scan, const Vector3d& view) {
  Vector3d along = scan.size() < 3 ? Vector3d::UnitX() : Vector3d(principalAxes(scan.points).col(2));
  along -= along.dot(view) * view;
  if (along.norm() < 1e-6) along = view.unitOrthogonal();
  return view.cross(along).normalized();
}

}  // namespace falciform
