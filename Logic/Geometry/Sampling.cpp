#include "Logic/Geometry/Sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace falciform {

namespace {

struct Cell {
  std::uint64_t key = 0;
  int id = -1;  ///< -1: free
  double squaredOffset = 0;
};

std::size_t slotOf(std::uint64_t key, std::size_t mask) {
  key *= 0x9E3779B97F4A7C15ULL;
  return (key ^ (key >> 32)) & mask;
}

}  // namespace

std::vector<int> voxelSample(const Points& points, double cellMm) {
  if (points.rows() == 0) return {};
  const Vector3d low = points.colwise().minCoeff();
  const double extent = (Vector3d(points.colwise().maxCoeff()) - low).maxCoeff();
  // A key has 21 bits an axis: cells finer than that of the extent cannot be told apart, nor need they.
  const double cell = std::max({cellMm, extent / 2e6, std::numeric_limits<double>::min()});

  std::size_t size = 16;
  while (size < 2 * static_cast<std::size_t>(points.rows())) size *= 2;
  std::vector<Cell> table(size);
  for (int i = 0; i < points.rows(); ++i) {
    const Vector3d place = (points.row(i).transpose() - low) / cell;
    const Vector3d corner = place.array().floor();
    const double squaredOffset = (place - corner - Vector3d::Constant(0.5)).squaredNorm();
    const std::uint64_t key = static_cast<std::uint64_t>(corner.x()) |
                              static_cast<std::uint64_t>(corner.y()) << 21 |
                              static_cast<std::uint64_t>(corner.z()) << 42;
    std::size_t slot = slotOf(key, size - 1);
    while (table[slot].id >= 0 && table[slot].key != key) slot = (slot + 1) & (size - 1);
    if (table[slot].id < 0 || squaredOffset < table[slot].squaredOffset)
      table[slot] = {key, i, squaredOffset};
  }
  std::vector<int> ids;
  for (const Cell& taken : table)
    if (taken.id >= 0) ids.push_back(taken.id);
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<int> spreadSample(const Points& points, Index count) {
  if (count <= 0 || points.rows() == 0) return {};
  std::vector<int> best(static_cast<std::size_t>(points.rows()));
  for (std::size_t i = 0; i < best.size(); ++i) best[i] = static_cast<int>(i);
  if (points.rows() <= count) return best;

  const double extent =
      (Vector3d(points.colwise().maxCoeff()) - Vector3d(points.colwise().minCoeff())).maxCoeff();
  const auto miss = [&](const std::vector<int>& ids) {
    return std::abs(static_cast<Index>(ids.size()) - count);
  };
  // Cells between the whole extent (one point) and a millionth of it, halved by ratio: 24 steps are finer
  // than the counts.
  double fine = 1e-6 * extent, coarse = 2 * extent;
  for (int step = 0; step < 24 && miss(best) > count / 100; ++step) {
    const double cell = std::sqrt(fine * coarse);
    std::vector<int> ids = voxelSample(points, cell);
    (static_cast<Index>(ids.size()) > count ? fine : coarse) = cell;
    if (miss(ids) < miss(best)) best = std::move(ids);
  }
  return best;
}

Points rowsOf(const Points& points, const std::vector<int>& ids) {
  Points rows(static_cast<Index>(ids.size()), 3);
  for (std::size_t i = 0; i < ids.size(); ++i) rows.row(static_cast<Index>(i)) = points.row(ids[i]);
  return rows;
}

}  // namespace falciform
