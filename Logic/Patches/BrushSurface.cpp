#include "Logic/Patches/BrushSurface.h"

#include <algorithm>
#include <cmath>

#include "Logic/Geometry/Geodesics.h"
#include "Logic/Geometry/Measures.h"

namespace falciform {

namespace {

/// Mean distance to the nearest neighbour, over at most 5,000 points evenly picked from the list.
double meanSpacing(const KdTree& tree, const Points& points) {
  const Index step = std::max<Index>(1, points.rows() / 5000);
  double sum = 0;
  Index count = 0;
  for (Index i = 0; i < points.rows(); i += step) {
    const std::vector<Neighbour> two = tree.nearest(points.row(i).transpose(), 2);
    if (two.size() < 2) continue;
    sum += std::sqrt(two[1].squaredDistance);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

/// Ends of the edges that belong to one triangle alone.
std::vector<char> borderOf(const Surface& mesh, const Adjacency& trianglesOfVertex) {
  std::vector<char> border(static_cast<std::size_t>(mesh.size()), 0);
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles(t, k), b = mesh.triangles(t, (k + 1) % 3);
      int shared = 0;
      for (const int* of = trianglesOfVertex.begin(a); of != trianglesOfVertex.end(a); ++of)
        shared += (mesh.triangles.row(*of).array() == b).any() ? 1 : 0;
      if (shared < 2) border[static_cast<std::size_t>(a)] = border[static_cast<std::size_t>(b)] = 1;
    }
  return border;
}

}  // namespace

BrushSurface::BrushSurface(const Surface& surface) {
  shape_.points = surface.points;
  shape_.triangles = surface.triangles;
  if (surface.triangles.rows() > 0) {
    shape_.normals = vertexNormals(surface);
    trianglesOfVertex_ = trianglesOfVertices(surface.triangles, surface.size());
    onBorder_ = borderOf(surface, trianglesOfVertex_);
  } else if (surface.size() > 0) {
    shape_.normals = surface.normals;
    tree_ = KdTree(surface.points);
    link_ = 3 * meanSpacing(tree_, surface.points);
  }
  weights_ = vertexAreas(shape_);
  onBorder_.resize(static_cast<std::size_t>(shape_.size()), 0);
}

bool BrushSurface::madeFrom(const Surface& surface) const {
  return surface.points == shape_.points && surface.triangles == shape_.triangles;
}

std::vector<int> BrushSurface::under(int triangle, const Vector3d& hit, const Vector3d& viewDirection,
                                     double radius) const {
  if (!hit.allFinite() || !viewDirection.allFinite()) return {};
  if (shape_.triangles.rows() == 0) return underOnCloud(hit, viewDirection, radius);
  if (triangle < 0 || triangle >= shape_.triangles.rows()) return {};
  return underOnMesh(triangle, hit, viewDirection, radius);
}

std::vector<int> BrushSurface::underOnMesh(int triangle, const Vector3d& hit, const Vector3d& view,
                                           double radius) const {
  const Vector3d a = shape_.points.row(shape_.triangles(triangle, 0)),
                 b = shape_.points.row(shape_.triangles(triangle, 1)),
                 c = shape_.points.row(shape_.triangles(triangle, 2));
  // The side of the surface that the camera sees at the hit.
  const Vector3d seen = (b - a).cross(c - a).dot(view) > 0 ? Vector3d(-view) : view;
  const auto facesCamera = [&](int vertex) { return shape_.normals.row(vertex).dot(seen) < 0; };
  std::function<bool(int)> allowed;
  if (view.squaredNorm() > 0) allowed = facesCamera;
  std::vector<int> ids;
  for (const GeodesicPoint& point :
       withinGeodesicRadius(shape_, trianglesOfVertex_, triangle, hit, radius, allowed))
    ids.push_back(point.vertex);
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<int> BrushSurface::underOnCloud(const Vector3d& hit, const Vector3d& view, double radius) const {
  const std::vector<int> near = tree_.empty() ? std::vector<int>() : tree_.within(hit, radius);
  if (near.empty()) return {};
  const int seed = tree_.nearest(hit).index;
  const bool faces = shape_.normals.rows() == shape_.size() && view.squaredNorm() > 0;
  const Vector3d seen = faces && shape_.normals.row(seed).dot(view) > 0 ? Vector3d(-view) : view;

  std::vector<char> reached(near.size(), 0);
  std::vector<int> ids;
  const auto reach = [&](int point) {
    const auto found = std::lower_bound(near.begin(), near.end(), point);
    if (found == near.end() || *found != point) return;
    char& mark = reached[static_cast<std::size_t>(found - near.begin())];
    if (mark != 0 || (faces && !(shape_.normals.row(point).dot(seen) < 0))) return;
    mark = 1;
    ids.push_back(point);
  };
  reach(seed);
  for (std::size_t next = 0; next < ids.size(); ++next)
    for (const int neighbour : tree_.within(shape_.points.row(ids[next]).transpose(), link_))
      reach(neighbour);
  std::sort(ids.begin(), ids.end());
  return ids;
}

void BrushSurface::neighbours(int point, std::vector<int>& result) const {
  if (isCloud()) {
    result = tree_.within(shape_.points.row(point).transpose(), link_);
    return;
  }
  result.clear();
  for (const int* t = trianglesOfVertex_.begin(point); t != trianglesOfVertex_.end(point); ++t)
    for (int k = 0; k < 3; ++k)
      if (const int other = shape_.triangles(*t, k); other != point) result.push_back(other);
}

std::vector<int> BrushSurface::around(const std::vector<int>& seeds, double radius) const {
  std::vector<int> ids;
  if (isCloud()) {
    std::vector<char> found(static_cast<std::size_t>(shape_.size()), 0);
    for (const int seed : seeds)
      for (const int id : tree_.within(shape_.points.row(seed).transpose(), radius))
        found[static_cast<std::size_t>(id)] = 1;
    for (std::size_t i = 0; i < found.size(); ++i)
      if (found[i] != 0) ids.push_back(static_cast<int>(i));
    return ids;
  }
  for (const GeodesicPoint& point : withinGeodesicRadius(shape_, trianglesOfVertex_, seeds, radius))
    ids.push_back(point.vertex);
  std::sort(ids.begin(), ids.end());
  return ids;
}

}  // namespace falciform
