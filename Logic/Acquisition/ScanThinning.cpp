#include "Logic/Acquisition/ScanThinning.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <queue>
#include <set>

#include "Logic/Core/Draws.h"

namespace falciform {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using Front =
    std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>>;

double length(const Points& points, int a, int b) { return (points.row(a) - points.row(b)).norm(); }

/// The id nearest to each point along the scan; -1 where none can be reached.
std::vector<int> nearestAlong(const Surface& scan, const Adjacency& neighbours, const std::vector<int>& ids) {
  std::vector<int> nearest(static_cast<std::size_t>(scan.size()), -1);
  std::vector<double> distance(nearest.size(), std::numeric_limits<double>::infinity());
  Front front;
  for (const int id : ids) {
    nearest[at(id)] = id;
    distance[at(id)] = 0;
    front.emplace(0.0, id);
  }
  while (!front.empty()) {
    const auto [reached, i] = front.top();
    front.pop();
    if (reached > distance[at(i)]) continue;
    for (const int* j = neighbours.begin(i); j != neighbours.end(i); ++j)
      if (const double next = reached + length(scan.points, i, *j); next < distance[at(*j)]) {
        distance[at(*j)] = next;
        nearest[at(*j)] = nearest[at(i)];
        front.emplace(next, *j);
      }
  }
  return nearest;
}

}  // namespace

std::vector<int> poissonDisks(const Surface& scan, const Adjacency& neighbours, double spacingMm, int seed) {
  const auto n = static_cast<std::size_t>(scan.size());
  std::vector<int> order(n), ids;
  std::iota(order.begin(), order.end(), 0);
  Draws draws(static_cast<std::uint64_t>(seed), 17);
  for (std::size_t i = n; i > 1; --i)
    std::swap(order[i - 1],
              order[std::min(static_cast<std::size_t>(draws.uniform(0, 1) * double(i)), i - 1)]);
  std::vector<double> distance(n, spacingMm);  // to the nearest disk's middle, no farther than its radius
  Front front;
  for (const int middle : order) {
    if (distance[at(middle)] < spacingMm) continue;
    ids.push_back(middle);
    distance[at(middle)] = 0;
    front.emplace(0.0, middle);
    while (!front.empty()) {
      const auto [reached, i] = front.top();
      front.pop();
      if (reached > distance[at(i)]) continue;
      for (const int* j = neighbours.begin(i); j != neighbours.end(i); ++j)
        if (const double next = reached + length(scan.points, i, *j); next < distance[at(*j)]) {
          distance[at(*j)] = next;
          front.emplace(next, *j);
        }
    }
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

Surface thinned(const Surface& scan, const Adjacency& neighbours, const std::vector<int>& ids) {
  Surface cloud = scan;
  cloud.triangles.resize(0, 3);
  Surface part = subset(cloud, ids);
  if (scan.triangles.rows() == 0) return part;
  std::vector<int> now(static_cast<std::size_t>(scan.size()), -1);
  for (std::size_t k = 0; k < ids.size(); ++k) now[at(ids[k])] = static_cast<int>(k);
  const std::vector<int> nearest = nearestAlong(scan, neighbours, ids);
  std::set<std::array<int, 3>> known;
  std::vector<int> corners;
  for (Index t = 0; t < scan.triangles.rows(); ++t) {
    std::array<int, 3> triangle{};
    for (std::size_t c = 0; c < 3; ++c) {
      const int owner = nearest[at(scan.triangles(t, static_cast<Index>(c)))];
      triangle[c] = owner < 0 ? -1 : now[at(owner)];
    }
    if (triangle[0] < 0 || triangle[1] < 0 || triangle[2] < 0 || triangle[0] == triangle[1] ||
        triangle[1] == triangle[2] || triangle[2] == triangle[0])
      continue;
    std::array<int, 3> sorted = triangle;
    std::sort(sorted.begin(), sorted.end());
    if (known.insert(sorted).second) corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  part.triangles = Eigen::Map<const Triangles>(corners.data(), static_cast<Index>(corners.size() / 3), 3);
  return part;
}

}  // namespace falciform
