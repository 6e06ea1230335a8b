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
  const Vector3d extent = high - low + Vector3d::Constant(2 * marginMm);
  const double cell = std::max(cellMm, std::cbrt(extent.prod() / kMostCells));
  low_ = (low - Vector3d::Constant(marginMm + cell)).cast<float>();  // one more cell all round
  perMm_ = static_cast<float>(1 / cell);
  counts_ = ((extent / cell).array().ceil() + 3).cast<int>();
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

/// Hands each cell's point on to the cells after it, then to those before it, twice: a vector distance
/// transform (Danielsson 1980). The outermost cells only receive in a last step, so that the inner loop needs
/// no checks.
void ClosestPointGrid::propagate(const Points& points) {
  std::vector<int> before;  // steps in memory to the 13 neighbours that come earlier
  for (int z = -1; z <= 0; ++z)
    for (int y = -1; y <= (z < 0 ? 1 : 0); ++y)
      for (int x = -1; x <= (z < 0 || y < 0 ? 1 : -1); ++x)
        before.push_back(x + counts_[0] * (y + counts_[1] * z));
  std::vector<float> squared(nearest_.size(), std::numeric_limits<float>::infinity());
  const Points::RealScalar* xyz = points.data();
  const auto improve = [&](int x, int y, int z, int direction) {
    const int here = x + counts_[0] * (y + counts_[1] * z);
    const Eigen::Vector3f centre =
        low_ + (Eigen::Vector3i(x, y, z).cast<float>() + Eigen::Vector3f::Constant(0.5F)) / perMm_;
    int& best = nearest_[static_cast<std::size_t>(here)];
    float& least = squared[static_cast<std::size_t>(here)];
    const auto distanceTo = [&](int point) {
      const double* p = xyz + 3 * static_cast<std::ptrdiff_t>(point);
      const float dx = static_cast<float>(p[0]) - centre.x(), dy = static_cast<float>(p[1]) - centre.y(),
                  dz = static_cast<float>(p[2]) - centre.z();
      return dx * dx + dy * dy + dz * dz;
    };
    if (best >= 0 && std::isinf(least)) least = distanceTo(best);
    for (const int step : before) {
      const int point = nearest_[static_cast<std::size_t>(here + direction * step)];
      if (point < 0 || point == best) continue;
      const float distance = distanceTo(point);
      if (distance < least) least = distance, best = point;
    }
  };
  for (int pass = 0; pass < 2; ++pass) {
    for (int z = 1; z < counts_[2] - 1; ++z)
      for (int y = 1; y < counts_[1] - 1; ++y)
        for (int x = 1; x < counts_[0] - 1; ++x) improve(x, y, z, 1);
    for (int z = counts_[2] - 2; z > 0; --z)
      for (int y = counts_[1] - 2; y > 0; --y)
        for (int x = counts_[0] - 2; x > 0; --x) improve(x, y, z, -1);
  }
  for (int z = 0; z < counts_[2]; ++z)
    for (int y = 0; y < counts_[1]; ++y)
      for (int x = 0; x < counts_[0]; ++x) {
        const Vector3i inner = Vector3i(x, y, z).cwiseMax(1).cwiseMin((counts_.array() - 2).matrix());
        nearest_[static_cast<std::size_t>(x + counts_[0] * (y + counts_[1] * z))] =
            nearest_[static_cast<std::size_t>(inner.x() + counts_[0] * (inner.y() + counts_[1] * inner.z()))];
      }
}

}  // namespace falciform
