#include "Logic/Registration/LabelledSource.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "Logic/Geometry/Sampling.h"

namespace falciform {

namespace {

std::uint64_t scrambled(std::uint64_t x) {  // splitmix64
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

}  // namespace

Points boxCorners(const Points& points) {
  const Eigen::RowVector3d low = points.colwise().minCoeff(), high = points.colwise().maxCoeff();
  Points corners(8, 3);
  for (int c = 0; c < 8; ++c)
    for (int a = 0; a < 3; ++a) corners(c, a) = (c >> a & 1) ? high[a] : low[a];
  return corners;
}

LabelledSource subsetOf(const LabelledSource& source, const std::vector<int>& ids) {
  LabelledSource part{rowsOf(source.points, ids), {}};
  part.labels.reserve(ids.size());
  for (const int i : ids) part.labels.push_back(source.labels[static_cast<std::size_t>(i)]);
  return part;
}

std::map<int, Vector3d> centroidsByLabel(const Points& points, const std::vector<int>& labels) {
  std::map<int, std::pair<Vector3d, double>> sums;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] <= 0) continue;
    auto& [sum, count] = sums.try_emplace(labels[i], Vector3d::Zero(), 0.0).first->second;
    sum += points.row(static_cast<Index>(i)).transpose();
    count += 1;
  }
  std::map<int, Vector3d> centroids;
  for (const auto& [label, sum] : sums) centroids[label] = sum.first / sum.second;
  return centroids;
}

std::vector<int> randomRows(Index rows, Index count) {
  std::vector<int> ids(static_cast<std::size_t>(rows));
  std::iota(ids.begin(), ids.end(), 0);
  if (rows <= count) return ids;
  std::vector<std::pair<std::uint64_t, int>> drawn;
  drawn.reserve(ids.size());
  for (const int i : ids) drawn.emplace_back(scrambled(static_cast<std::uint64_t>(i)), i);
  std::nth_element(drawn.begin(), drawn.begin() + count, drawn.end());
  ids.clear();
  for (Index k = 0; k < count; ++k) ids.push_back(drawn[static_cast<std::size_t>(k)].second);
  std::sort(ids.begin(), ids.end());
  return ids;
}

}  // namespace falciform
