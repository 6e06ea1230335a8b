#include "Logic/Acquisition/ScanFacing.h"

#include <Eigen/Eigenvalues>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"

namespace falciform {

namespace {

constexpr int kPlanePoints = 12;
constexpr std::size_t kChunk = 1024;

/// Sum of the triangles' areas as vectors, mm^2.
Vector3d areaVector(const Surface& scan) {
  Vector3d sum = Vector3d::Zero();
  for (Index t = 0; t < scan.triangles.rows(); ++t) {
    const Vector3d a = scan.points.row(scan.triangles(t, 0)), b = scan.points.row(scan.triangles(t, 1)),
                   c = scan.points.row(scan.triangles(t, 2));
    sum += (b - a).cross(c - a) / 2;
  }
  return sum;
}

Vector3d thinnestAxis(const Points& points) {
  const Points centred = points.rowwise() - points.colwise().mean();
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(centred.transpose() * centred).eigenvectors().col(0);
}

}  // namespace

void faceTowards(Surface& scan, const Vector3d& towardsScanner) {
  if (areaVector(scan).dot(towardsScanner) < 0) scan.triangles.col(1).swap(scan.triangles.col(2));
  for (Index i = 0; i < scan.normals.rows(); ++i)
    if (scan.normals.row(i).dot(towardsScanner) < 0) scan.normals.row(i) *= -1;
}

void giveNormals(Surface& scan, const Vector3d& towardsScanner) {
  if (scan.triangles.rows() > 0) {
    scan.normals = vertexNormals(scan);
    return;
  }
  scan.normals.resize(scan.size(), 3);
  const KdTree tree(scan.points);
  forEachChunk(static_cast<std::size_t>(scan.size()), kChunk, [&](std::size_t begin, std::size_t end) {
    for (Index i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) {
      const auto near = tree.nearest(scan.points.row(i).transpose(), kPlanePoints);
      Points around(static_cast<Index>(near.size()), 3);
      for (std::size_t k = 0; k < near.size(); ++k)
        around.row(static_cast<Index>(k)) = scan.points.row(near[k].index);
      const Vector3d normal = near.size() < 3 ? towardsScanner : thinnestAxis(around);
      scan.normals.row(i) = (normal.dot(towardsScanner) < 0 ? -normal : normal).transpose();
    }
  });
}

}  // namespace falciform
