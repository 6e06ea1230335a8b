#include "Logic/Geometry/Measures.h"

#include <cmath>

#include "Logic/Geometry/Topology.h"

namespace falciform {

namespace {

Vector3d corner(const Surface& surface, Index triangle, int c) {
  return surface.points.row(surface.triangles(triangle, c)).transpose();
}

/// Twice the area long, outwards.
Vector3d areaVector(const Surface& surface, Index f) {
  const Vector3d a = corner(surface, f, 0);
  return (corner(surface, f, 1) - a).cross(corner(surface, f, 2) - a);
}

}  // namespace

double area(const Surface& surface) {
  double sum = 0;
  for (Index f = 0; f < surface.triangles.rows(); ++f) sum += areaVector(surface, f).norm() / 2;
  return sum;
}

double signedVolume(const Surface& surface) {
  if (surface.triangles.rows() == 0) return 0;
  // About the centroid, so that a body far from the origin loses no digits.
  const Vector3d origin = centroid(surface.points);
  double sum = 0;
  for (Index f = 0; f < surface.triangles.rows(); ++f)
    sum += (corner(surface, f, 0) - origin).dot(areaVector(surface, f)) / 6;
  return sum;
}

double meanEdgeLength(const Surface& surface) {
  const Adjacency ring = neighboursOfVertices(surface.triangles, surface.size());
  double sum = 0;
  Index edges = 0;
  for (int v = 0; v < surface.size(); ++v)
    for (const int* other = ring.begin(v); other != ring.end(v); ++other)
      if (*other > v) {
        sum += (surface.points.row(v) - surface.points.row(*other)).norm();
        ++edges;
      }
  return edges == 0 ? 0 : sum / static_cast<double>(edges);
}

Vector3d centroid(const Points& points) {
  if (points.rows() == 0) return Vector3d::Zero();
  return points.colwise().mean().transpose();
}

Eigen::Matrix<double, 2, 3> boundingBox(const Points& points) {
  Eigen::Matrix<double, 2, 3> box = Eigen::Matrix<double, 2, 3>::Zero();
  if (points.rows() == 0) return box;
  box.row(0) = points.colwise().minCoeff();
  box.row(1) = points.colwise().maxCoeff();
  return box;
}

VectorXd vertexAreas(const Surface& surface) {
  if (surface.triangles.rows() == 0) return VectorXd::Ones(surface.size());
  VectorXd areas = VectorXd::Zero(surface.size());
  for (Index f = 0; f < surface.triangles.rows(); ++f) {
    const double third = areaVector(surface, f).norm() / 6;
    for (int c = 0; c < 3; ++c) areas[surface.triangles(f, c)] += third;
  }
  return areas;
}

Points vertexNormals(const Surface& surface) {
  Points normals = Points::Zero(surface.size(), 3);
  for (Index f = 0; f < surface.triangles.rows(); ++f) {
    const Vector3d n = areaVector(surface, f);
    const double length = n.norm();
    if (!(length > 0)) continue;
    for (int c = 0; c < 3; ++c) {
      const Vector3d here = corner(surface, f, c);
      const Vector3d u = corner(surface, f, (c + 1) % 3) - here, v = corner(surface, f, (c + 2) % 3) - here;
      const double angle = std::atan2(length, u.dot(v));  // |u x v| is the same at every corner
      normals.row(surface.triangles(f, c)) += angle / length * n.transpose();
    }
  }
  for (Index i = 0; i < normals.rows(); ++i) {
    const double length = normals.row(i).norm();
    if (length > 0) normals.row(i) /= length;
  }
  return normals;
}

}  // namespace falciform
