#include "Logic/Geometry/ClosestPointGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace falciform {

namespace {

constexpr double kMostCells = 4e6;

}  // namespace

ClosestPointGrid::ClosestPointGrid(const Points& points, const std::vector<int>& ids, double cellMm,
                                   double marginMm) {
  Vector3d low = points.row(ids.front()).transpose(), high = low;
  for (const int i : ids) {
    low = low.cwiseMin(points.row(i).transpose());
    high = high.cwiseMax(points.row(i).transpose());
  }
  low_ = (low - Vector3d::Constant(marginMm)).cast<float>();
  const Vector3d extent = high - low + Vector3d::Constant(2 * marginMm + 1e-6);
  const double cell = std::max(cellMm, std::cbrt(extent.prod() / kMostCells));
  perMm_ = static_cast<float>(1 / cell);
  counts_ = (extent / cell).array().ceil().max(1).cast<int>();
  nearest_.assign(static_cast<std::size_t>(counts_.prod()), -1);

  std::vector<float> offsets(nearest_.size(), std::numeric_limits<float>::infinity());
  for (const int i : ids) {
    const Eigen::Vector3f place = (points.row(i).transpose().cast<float>() - low_) * perMm_;
    const Vector3i at(cellOf(place.x(), counts_[0]), cellOf(place.y(), counts_[1]),
                      cellOf(place.z(), counts_[2]));
    const auto index = static_cast<std::size_t>(at.x() + counts_[0] * (at.y() + counts_[1] * at.z()));
    const float offset = (place - at.cast<float>() - Eigen::Vector3f::Constant(0.5F)).squaredNorm();
    if (offset < offsets[index]) offsets[index] = offset, nearest_[index] = i;
  }
  propagate(points);
}

/// Hands each cell's point on to the cells after it, then to those before it, and once more: what a
/// two-pass vector distance transform does (Danielsson 1980).
void ClosestPointGrid::propagate(const Points& points) {
  std::vector<Vector3i> before;  // the 13 neighbours that come earlier in memory
  for (int z = -1; z <= 0; ++z)
    for (int y = -1; y <= (z < 0 ? 1 : 0); ++y)
      for (int x = -1; x <= (z < 0 || y < 0 ? 1 : -1); ++x) before.emplace_back(x, y, z);
  std::vector<double> squared(nearest_.size(), std::numeric_limits<double>::infinity());
  const double cell = cellMm();
  const auto centreOf = [&](const Vector3i& at) -> Vector3d {
    return low_.cast<double>() + cell * (at.cast<double>() + Vector3d::Constant(0.5));
  };
  const auto indexOf = [&](const Vector3i& at) {
    return static_cast<std::size_t>(at.x() + counts_[0] * (at.y() + counts_[1] * at.z()));
  };
  const auto improve = [&](const Vector3i& at, int direction) {
    const std::size_t here = indexOf(at);
    const Vector3d centre = centreOf(at);
    if (nearest_[here] >= 0 && std::isinf(squared[here]))
      squared[here] = (points.row(nearest_[here]).transpose() - centre).squaredNorm();
    for (const Vector3i& step : before) {
      const Vector3i from = at + direction * step;
      if ((from.array() < 0).any() || (from.array() >= counts_.array()).any()) continue;
      const int point = nearest_[indexOf(from)];
      if (point < 0 || point == nearest_[here]) continue;
      const double distance = (points.row(point).transpose() - centre).squaredNorm();
      if (distance < squared[here]) squared[here] = distance, nearest_[here] = point;
    }
  };
  for (int pass = 0; pass < 2; ++pass) {
    for (int z = 0; z < counts_[2]; ++z)
      for (int y = 0; y < counts_[1]; ++y)
        for (int x = 0; x < counts_[0]; ++x) improve({x, y, z}, 1);
    for (int z = counts_[2] - 1; z >= 0; --z)
      for (int y = counts_[1] - 1; y >= 0; --y)
        for (int x = counts_[0] - 1; x >= 0; --x) improve({x, y, z}, -1);
  }
}

}  // namespace falciform
