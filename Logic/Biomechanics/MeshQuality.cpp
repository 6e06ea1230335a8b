#include "Logic/Biomechanics/MeshQuality.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "Logic/Biomechanics/ReferenceTetrahedron.h"
#include "Logic/Core/Median.h"

namespace falciform {

namespace {

using Corners = std::array<Vector3d, 4>;

Corners cornersOf(const TetrahedralMesh& mesh, Index element) {
  Corners corners;
  for (std::size_t k = 0; k < 4; ++k)
    corners[k] = mesh.points.row(mesh.elements(element, static_cast<Index>(k))).transpose();
  return corners;
}

}  // namespace

ElementShape shapeOf(const TetrahedralMesh& mesh, Index element) {
  const Corners p = cornersOf(mesh, element);
  const Vector3d a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
  const double sixVolumes = a.cross(b).dot(c);
  std::array<Vector3d, 4> normals;  // outward, twice the area of the face opposite to each corner
  normals[1] = c.cross(b);
  normals[2] = a.cross(c);
  normals[3] = b.cross(a);
  normals[0] = -(normals[1] + normals[2] + normals[3]);
  ElementShape shape;
  double largestCosine = -1, areas = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    areas += normals[i].norm() / 2;
    for (std::size_t j = i + 1; j < 4; ++j)
      largestCosine =
          std::max(largestCosine, -normals[i].dot(normals[j]) / (normals[i].norm() * normals[j].norm()));
  }
  shape.minDihedralDeg = std::acos(std::clamp(largestCosine, -1.0, 1.0)) * 180 / EIGEN_PI;
  const double inscribed = sixVolumes / 2 / areas;
  const Vector3d toCentre =
      (a.squaredNorm() * b.cross(c) + b.squaredNorm() * c.cross(a) + c.squaredNorm() * a.cross(b)) /
      (2 * sixVolumes);
  shape.radiusRatio = sixVolumes > 0 ? 3 * inscribed / toCentre.norm() : 0;
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    double product = 1;
    for (std::size_t j = 0; j < 4; ++j)
      if (j != i) product *= (p[j] - p[i]).norm();
    longest = std::max(longest, product);
  }
  shape.scaledJacobian = std::sqrt(2.0) * sixVolumes / longest;
  return shape;
}

MeshQuality meshQuality(const TetrahedralMesh& mesh) {
  MeshQuality quality{.minDihedralDeg = 180, .minRadiusRatio = 1, .minScaledJacobian = 1};
  std::vector<double> dihedrals;
  for (Index e = 0; e < mesh.size(); ++e) {
    const ElementShape shape = shapeOf(mesh, e);
    dihedrals.push_back(shape.minDihedralDeg);
    quality.minDihedralDeg = std::min(quality.minDihedralDeg, shape.minDihedralDeg);
    quality.minRadiusRatio = std::min(quality.minRadiusRatio, shape.radiusRatio);
    quality.minScaledJacobian = std::min(quality.minScaledJacobian, shape.scaledJacobian);
    quality.volumeMm3 += cornerVolume(mesh, e);
    for (const auto& [a, b] : kTetrahedronEdges)
      quality.meanEdgeMm +=
          (mesh.points.row(mesh.elements(e, a)) - mesh.points.row(mesh.elements(e, b))).norm() /
          (6.0 * static_cast<double>(mesh.size()));
  }
  quality.medianDihedralDeg = medianInPlace(dihedrals);
  return quality;
}

}  // namespace falciform
