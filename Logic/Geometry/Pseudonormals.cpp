#include "Logic/Geometry/Pseudonormals.h"

#include <algorithm>
#include <cmath>

#include "Logic/Geometry/SamePlaces.h"

namespace falciform {

namespace {

struct HalfEdge {
  int other, triangle, side;
};

}  // namespace

Vector3d faceNormal(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d cross = (b - a).cross(c - a);
  return cross.squaredNorm() > 0 ? cross.stableNormalized() : Vector3d::Zero();
}

Pseudonormals pseudonormals(const Points& points, const Triangles& triangles) {
  const std::vector<int> first = firstInSamePlace(points);
  const auto place = [&](Index t, int k) { return first[static_cast<std::size_t>(triangles(t, k % 3))]; };
  Pseudonormals normals;
  normals.face = Points::Zero(triangles.rows(), 3);
  normals.corner = Points::Zero(points.rows(), 3);
  normals.edge.assign(static_cast<std::size_t>(triangles.rows()),
                      {Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()});

  std::vector<int> start(static_cast<std::size_t>(points.rows()) + 1, 0);
  for (Index t = 0; t < triangles.rows(); ++t) {
    std::array<Vector3d, 3> p;
    for (int k = 0; k < 3; ++k) p[static_cast<std::size_t>(k)] = points.row(triangles(t, k));
    normals.face.row(t) = faceNormal(p[0], p[1], p[2]).transpose();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d u = p[(k + 1) % 3] - p[k], v = p[(k + 2) % 3] - p[k];
      const double angle = std::atan2(u.cross(v).norm(), u.dot(v));
      normals.corner.row(place(t, static_cast<int>(k))) += angle * normals.face.row(t);
      const int a = place(t, static_cast<int>(k)), b = place(t, static_cast<int>(k) + 1);
      ++start[static_cast<std::size_t>(std::min(a, b)) + 1];
    }
  }
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];

  // Sides of triangles, gathered under the lower end of their edge, then matched by the higher.
  std::vector<HalfEdge> sides(static_cast<std::size_t>(3 * triangles.rows()));
  std::vector<int> fill(start.begin(), start.end() - 1);
  for (Index t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = place(t, k), b = place(t, k + 1);
      sides[static_cast<std::size_t>(fill[static_cast<std::size_t>(std::min(a, b))]++)] = {
          std::max(a, b), static_cast<int>(t), k};
    }
  for (std::size_t v = 0; v + 1 < start.size(); ++v) {
    const auto begin = sides.begin() + start[v], end = sides.begin() + start[v + 1];
    std::sort(begin, end, [](const HalfEdge& x, const HalfEdge& y) {
      return x.other != y.other ? x.other < y.other : x.triangle < y.triangle;
    });
    for (auto from = begin; from != end;) {
      auto to = from;
      Vector3d sum = Vector3d::Zero();
      for (; to != end && to->other == from->other; ++to) sum += normals.face.row(to->triangle);
      for (; from != to; ++from)
        normals.edge[static_cast<std::size_t>(from->triangle)][static_cast<std::size_t>(from->side)] = sum;
    }
  }
  for (Index i = 0; i < points.rows(); ++i)
    normals.corner.row(i) = normals.corner.row(first[static_cast<std::size_t>(i)]).eval();
  return normals;
}

}  // namespace falciform
