#include "Logic/Geometry/TriangleTree.h"

#include <cmath>
#include <mutex>
#include <vector>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/BoxTree.h"
#include "Logic/Geometry/Pseudonormals.h"
#include "Logic/Geometry/TrianglePlaces.h"

namespace falciform {

namespace {

BoxTree boxesOf(const Surface& surface) {
  if (surface.triangles.rows() == 0)
    throw InputError("the surface has no triangles; a triangle surface is needed here");
  Points low(surface.triangles.rows(), 3), high(surface.triangles.rows(), 3);
  for (Index t = 0; t < surface.triangles.rows(); ++t) {
    const auto a = surface.points.row(surface.triangles(t, 0)),
               b = surface.points.row(surface.triangles(t, 1)),
               c = surface.points.row(surface.triangles(t, 2));
    low.row(t) = a.cwiseMin(b).cwiseMin(c);
    high.row(t) = a.cwiseMax(b).cwiseMax(c);
  }
  return {low, high};
}

}  // namespace

struct TriangleTree::Tree {
  explicit Tree(const Surface& surface)
      : boxes(boxesOf(surface)), points(surface.points), triangles(surface.triangles) {
    corners.reserve(boxes.order().size());
    for (const int t : boxes.order()) {
      Corners c{surface.points.row(triangles(t, 0)), surface.points.row(triangles(t, 1)),
                surface.points.row(triangles(t, 2))};
      c.sliver = isSliver(c.a, c.b, c.c);
      corners.push_back(c);
    }
  }

  [[nodiscard]] Vector3d normalAt(int triangle, TrianglePart part) const {
    std::call_once(normalsMade, [&] { normals = pseudonormals(points, triangles); });
    if (part == TrianglePart::Face) return normals.face.row(triangle);
    const int edge = static_cast<int>(part) - static_cast<int>(TrianglePart::EdgeAb);
    if (edge < 3) return normals.edge[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(edge)];
    return normals.corner.row(triangles(triangle, edge - 3));
  }

  BoxTree boxes;
  Points points;
  Triangles triangles;
  mutable std::once_flag normalsMade;  // who only casts rays, as the brush does, does not wait for them
  mutable Pseudonormals normals;
  std::vector<Corners> corners;  ///< in the order of the leaves
};

TriangleTree::TriangleTree(const Surface& surface) : tree_(std::make_shared<const Tree>(surface)) {}

struct TriangleTree::Found {
  ClosestPlace place;
  TrianglePart part = TrianglePart::Face;
};

TriangleTree::Found TriangleTree::find(const Vector3d& query, double bound) const {
  double best = bound * bound;
  int bestTriangle = std::numeric_limits<int>::max();
  PlaceOnTriangle bestPlace;
  const std::vector<int>& order = tree_->boxes.order();
  tree_->boxes.visitNear(query, best, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const PlaceOnTriangle place = closestPlace(query, tree_->corners[static_cast<std::size_t>(i)]);
      const int triangle = order[static_cast<std::size_t>(i)];
      if (place.squaredDistance < best || (place.squaredDistance == best && triangle < bestTriangle)) {
        best = place.squaredDistance;
        bestTriangle = triangle;
        bestPlace = place;
      }
    }
  });
  if (bestTriangle == std::numeric_limits<int>::max()) return {};
  return {{bestTriangle, bestPlace.point, bestPlace.barycentric, std::sqrt(best)}, bestPlace.part};
}

ClosestPlace TriangleTree::closest(const Vector3d& query, double bound) const {
  auto [place, part] = find(query, bound);
  if (place.triangle >= 0 && (query - place.point).dot(tree_->normalAt(place.triangle, part)) < 0)
    place.side = -1;
  return place;
}

ClosestPlace TriangleTree::closestAnySide(const Vector3d& query, double bound) const {
  return find(query, bound).place;
}

std::optional<RayHit> TriangleTree::cast(const Vector3d& origin, const Vector3d& direction) const {
  const Vector3d along = direction.stableNormalized();
  double best = std::numeric_limits<double>::infinity();
  int bestTriangle = -1;
  const std::vector<int>& order = tree_->boxes.order();
  tree_->boxes.visitAlong(origin, along, best, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const double distance = rayDistance(origin, along, tree_->corners[static_cast<std::size_t>(i)]);
      const int triangle = order[static_cast<std::size_t>(i)];
      if (distance < best || (distance == best && triangle < bestTriangle)) {
        best = distance;
        bestTriangle = triangle;
      }
    }
  });
  if (bestTriangle < 0) return std::nullopt;
  return RayHit{bestTriangle, best, origin + best * along};
}

int TriangleTree::vertexOf(int triangle, int corner) const { return tree_->triangles(triangle, corner); }

Vector3d TriangleTree::triangleNormal(int triangle) const {
  const auto corner = [&](int c) -> Vector3d { return tree_->points.row(tree_->triangles(triangle, c)); };
  return faceNormal(corner(0), corner(1), corner(2));
}

}  // namespace falciform
