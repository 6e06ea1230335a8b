#include "Logic/Biomechanics/ReferenceTetrahedron.h"

#include <cmath>

namespace falciform {

Eigen::VectorXd shapeValues(const Eigen::Vector4d& barycentric, int nodes) {
  if (nodes == 4) return barycentric;
  Eigen::VectorXd values(10);
  for (int k = 0; k < 4; ++k) values[k] = barycentric[k] * (2 * barycentric[k] - 1);
  for (int k = 0; k < 6; ++k)
    values[4 + k] = 4 * barycentric[kTetrahedronEdges[k][0]] * barycentric[kTetrahedronEdges[k][1]];
  return values;
}

Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor, 10, 3> shapeGradients(
    const Eigen::Vector4d& barycentric, const Eigen::Matrix<double, 4, 3>& gradients, int nodes) {
  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor, 10, 3> result(nodes, 3);
  if (nodes == 4) {
    result = gradients;
    return result;
  }
  for (int k = 0; k < 4; ++k) result.row(k) = (4 * barycentric[k] - 1) * gradients.row(k);
  for (int k = 0; k < 6; ++k) {
    const auto [a, b] = kTetrahedronEdges[k];
    result.row(4 + k) = 4 * (barycentric[b] * gradients.row(a) + barycentric[a] * gradients.row(b));
  }
  return result;
}

Eigen::Matrix<double, 4, 3> barycentricGradients(const TetrahedralMesh& mesh, Index e) {
  const auto corner = [&](int k) { return Vector3d(mesh.points.row(mesh.elements(e, k)).transpose()); };
  const Vector3d a = corner(0), ab = corner(1) - a, ac = corner(2) - a, ad = corner(3) - a;
  const double sixVolumes = ab.cross(ac).dot(ad);
  Eigen::Matrix<double, 4, 3> gradients;
  gradients.row(1) = ac.cross(ad).transpose() / sixVolumes;
  gradients.row(2) = ad.cross(ab).transpose() / sixVolumes;
  gradients.row(3) = ab.cross(ac).transpose() / sixVolumes;
  gradients.row(0) = -(gradients.row(1) + gradients.row(2) + gradients.row(3));
  return gradients;
}

const std::vector<Eigen::Vector4d>& quadraturePlaces(bool quadratic) {
  static const double far = (5 - std::sqrt(5.0)) / 20, near = 1 - 3 * far;  // exact to second degree
  static const std::vector<Eigen::Vector4d> one{Eigen::Vector4d::Constant(0.25)};
  static const std::vector<Eigen::Vector4d> four{
      {near, far, far, far}, {far, near, far, far}, {far, far, near, far}, {far, far, far, near}};
  return quadratic ? four : one;
}

}  // namespace falciform
