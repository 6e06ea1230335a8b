#include "Logic/Deformation/SurfaceBorder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "Logic/Geometry/SamePlaces.h"

namespace falciform {

SurfaceBorder::SurfaceBorder(const Surface& surface) {
  const std::vector<int> first = firstInSamePlace(surface.points);
  const auto place = [&](Index t, int k) {
    return first[static_cast<std::size_t>(surface.triangles(t, k % 3))];
  };
  struct Side {
    int low, high, triangle, side;
  };
  std::vector<Side> sides;
  sides.reserve(static_cast<std::size_t>(3 * surface.triangles.rows()));
  for (Index t = 0; t < surface.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({place(t, k), place(t, k + 1)});
      sides.push_back({low, high, static_cast<int>(t), k});
    }
  std::sort(sides.begin(), sides.end(),
            [](const Side& x, const Side& y) { return std::pair(x.low, x.high) < std::pair(y.low, y.high); });

  edge_.assign(static_cast<std::size_t>(surface.triangles.rows()), {});
  corner_ = edge_;
  std::vector<char> onBorder(first.size(), 0);
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
    if (end - i == 1 && sides[i].low != sides[i].high) {
      edge_[static_cast<std::size_t>(sides[i].triangle)][static_cast<std::size_t>(sides[i].side)] = 1;
      onBorder[static_cast<std::size_t>(sides[i].low)] = onBorder[static_cast<std::size_t>(sides[i].high)] =
          1;
      empty_ = false;
    }
    i = end;
  }
  for (Index t = 0; t < surface.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      corner_[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)] =
          onBorder[static_cast<std::size_t>(place(t, k))];
}

bool SurfaceBorder::holds(int triangle, const Vector3d& barycentric) const {
  if (empty_) return false;
  constexpr double zero = 1e-9;  // of weights that sum to 1
  const auto t = static_cast<std::size_t>(triangle);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = [&](std::size_t corner) { return barycentric[static_cast<Index>(corner % 3)]; };
    if (corner_[t][k] != 0 && at(k) > 1 - zero) return true;
    if (edge_[t][k] != 0 && at(k + 2) < zero) return true;
  }
  return false;
}

bool leadsAside(const Vector3d& offset, const Vector3d& normal, const Vector3d& otherNormal) {
  const double length = offset.norm();
  if (!(length > 1e-9)) return false;  // mm: the two surfaces touch there
  const double straight = std::max(std::abs(offset.dot(normal)), std::abs(offset.dot(otherNormal)));
  return straight < std::cos(15 * std::numbers::pi / 180) * length;
}

bool beyondCloud(const KdTree& cloud, const Points& points, int nearest, const Vector3d& query,
                 const Vector3d& normal) {
  const auto inPlane = [&](int id) {
    const Vector3d way = points.row(id).transpose() - query;
    return Vector3d(way - way.dot(normal) * normal);
  };
  const Vector3d foot = points.row(nearest);
  double spacing = 0;
  const std::vector<Neighbour> around = cloud.nearest(foot, 7);
  for (const Neighbour& neighbour : around) spacing += std::sqrt(neighbour.squaredDistance);
  spacing /= std::max<double>(1, static_cast<double>(around.size()) - 1);  // the first is the point itself
  if (inPlane(nearest).norm() <= 0.5 * spacing) return false;

  std::vector<double> bearings;
  const Vector3d east = normal.unitOrthogonal(), north = normal.cross(east);
  for (const int id : cloud.within(query, (foot - query).norm() + 3 * spacing)) {
    const Vector3d way = inPlane(id);
    if (way.norm() > 1e-9) bearings.push_back(std::atan2(way.dot(north), way.dot(east)));
  }
  if (bearings.size() < 3) return true;
  std::sort(bearings.begin(), bearings.end());
  double gap = 2 * std::numbers::pi - (bearings.back() - bearings.front());
  for (std::size_t i = 1; i < bearings.size(); ++i) gap = std::max(gap, bearings[i] - bearings[i - 1]);
  return gap > std::numbers::pi;
}

}  // namespace falciform
