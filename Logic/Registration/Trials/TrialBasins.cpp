#include "Logic/Registration/Trials/TrialBasins.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace falciform {

namespace {

/// Directions spread evenly over the sphere (Fibonacci lattice).
Vector3d latticeDirection(int i, int count) {
  const double z = 1 - (2 * i + 1.0) / count, turn = 2 * std::numbers::pi * i / std::numbers::phi;
  const double radius = std::sqrt(1 - z * z);
  return {radius * std::cos(turn), radius * std::sin(turn), z};
}

bool near(const Isometry3d& a, const Isometry3d& b, const Points& outermost, double withinMm) {
  const Matrix3d turn = a.linear() - b.linear();
  const Vector3d shift = a.translation() - b.translation();
  for (Index i = 0; i < outermost.rows(); ++i)
    if ((turn * outermost.row(i).transpose() + shift).squaredNorm() > withinMm * withinMm) return false;
  return true;
}

/// Indices 0 ... n - 1 by `less`, equals in their order.
template <class Less>
std::vector<std::size_t> ordered(std::size_t n, const Less& less) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), less);
  return order;
}

}  // namespace

Points outermostPoints(const Points& points, int directions) {
  std::vector<Index> ids;
  for (int i = 0; i < directions; ++i) {
    Index best = 0;
    (points * latticeDirection(i, directions)).maxCoeff(&best);
    ids.push_back(best);
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return points(ids, Eigen::all);
}

std::vector<int> trialBasins(const std::vector<TrialRecord>& records, const Points& outermost,
                             double withinMm) {
  // The best fit leads: a stray pose beside a tight group shall not cut the group in two.
  const auto byFit = ordered(
      records.size(), [&](std::size_t a, std::size_t b) { return records[a].rmsMm < records[b].rmsMm; });
  std::vector<std::size_t> leaders, members;  // a basin each
  std::vector<std::size_t> basinOf(records.size());
  for (const std::size_t i : byFit) {
    const auto found = std::find_if(leaders.begin(), leaders.end(), [&](std::size_t leader) {
      return near(records[i].error, records[leader].error, outermost, withinMm);
    });
    basinOf[i] = static_cast<std::size_t>(found - leaders.begin());
    if (found == leaders.end()) {
      leaders.push_back(i);
      members.push_back(0);
    }
    ++members[basinOf[i]];
  }
  const auto bySize =
      ordered(leaders.size(), [&](std::size_t a, std::size_t b) { return members[a] > members[b]; });
  std::vector<int> numberOf(leaders.size()), basins(records.size());
  for (std::size_t k = 0; k < bySize.size(); ++k) numberOf[bySize[k]] = static_cast<int>(k) + 1;
  for (std::size_t i = 0; i < records.size(); ++i) basins[i] = numberOf[basinOf[i]];
  return basins;
}

}  // namespace falciform
