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

CloudBorder::CloudBorder(const KdTree& cloud, const Points& points) : cloud_(cloud), points_(points) {
  if (points.rows() == 0) return;
  std::vector<double> spacings;
  const Index step = std::max<Index>(1, points.rows() / 2000);  // 2,000 give the median to 3 %
  for (Index i = 0; i < points.rows(); i += step) spacings.push_back(spacingAt(static_cast<int>(i)));
  const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  largest_ = 1.5 * *middle;
}

double CloudBorder::spacingAt(int point) const {
  double sum = 0;
  const std::vector<Neighbour> around = cloud_.nearest(points_.row(point).transpose(), 7);
  for (const Neighbour& neighbour : around) sum += std::sqrt(neighbour.squaredDistance);
  const double others =
      std::max<double>(1, static_cast<double>(around.size()) - 1);  // the first is the point itself
  return std::min(sum / others, largest_);
}

bool CloudBorder::isPassed(const Vector3d& query, const Vector3d& normal, int nearest) const {
  const auto inPlane = [&](const Vector3d& way) { return Vector3d(way - way.dot(normal) * normal); };
  const Vector3d foot = points_.row(nearest), outwards = inPlane(query - foot);
  const double spacing = spacingAt(nearest), aside = outwards.norm();
  if (aside <= 0.5 * spacing) return false;
  const double leastCosine = std::sqrt(0.5);  // of 45 deg
  for (const int id : cloud_.within(foot, 3 * spacing)) {
    const Vector3d way = inPlane(points_.row(id).transpose() - foot);
    if (way.dot(outwards) > leastCosine * way.norm() * aside) return false;  // the cloud goes on that way
  }
  return true;
}

}  // namespace falciform
