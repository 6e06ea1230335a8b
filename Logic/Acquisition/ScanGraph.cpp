#include "Logic/Acquisition/ScanGraph.h"

#include <algorithm>
#include <numeric>
#include <queue>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"

namespace falciform {

namespace {

constexpr int kNearest = 8;      // as a raster has them
constexpr double kFarthest = 3;  // spacings: farther is another piece
constexpr std::size_t kChunk = 1024;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double length(const Points& points, int a, int b) { return (points.row(a) - points.row(b)).norm(); }

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Adjacency cloudNeighbours(const Points& points) {
  const KdTree tree(points);
  std::vector<std::vector<Neighbour>> near(static_cast<std::size_t>(points.rows()));
  forEachChunk(near.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      near[i] = tree.nearest(points.row(static_cast<Index>(i)).transpose(), kNearest + 1);
  });
  std::vector<double> steps;
  for (const auto& found : near)
    if (found.size() > 1) steps.push_back(found[1].squaredDistance);
  const double farthest = kFarthest * kFarthest * medianOf(steps);

  std::vector<std::pair<int, int>> edges;
  for (std::size_t i = 0; i < near.size(); ++i)
    for (const Neighbour& other : near[i])
      if (other.index != static_cast<int>(i) && other.squaredDistance <= farthest) {
        edges.emplace_back(static_cast<int>(i), other.index);
        edges.emplace_back(other.index, static_cast<int>(i));
      }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  Adjacency lists;
  lists.start.assign(near.size() + 1, 0);
  for (const auto& [from, to] : edges) {
    ++lists.start[at(from) + 1];
    lists.values.push_back(to);
  }
  std::partial_sum(lists.start.begin(), lists.start.end(), lists.start.begin());
  return lists;
}

}  // namespace

Adjacency scanNeighbours(const Surface& scan) {
  return scan.triangles.rows() > 0 ? neighboursOfVertices(scan.triangles, scan.size())
                                   : cloudNeighbours(scan.points);
}

double usualSpacing(const Surface& scan, const Adjacency& neighbours) {
  std::vector<double> steps;
  steps.reserve(neighbours.values.size());
  for (int i = 0; i < static_cast<int>(scan.size()); ++i)
    for (const int* j = neighbours.begin(i); j != neighbours.end(i); ++j)
      if (*j > i) steps.push_back(length(scan.points, i, *j));
  return medianOf(std::move(steps));
}

std::vector<double> distancesAlong(const Surface& scan, const Adjacency& neighbours,
                                   const std::vector<char>& sources, const std::vector<char>& allowed,
                                   double limit) {
  std::vector<double> distance(sources.size(), limit);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (sources[i] && allowed[i]) {
      distance[i] = 0;
      front.emplace(0.0, static_cast<int>(i));
    }
  while (!front.empty()) {
    const auto [reached, i] = front.top();
    front.pop();
    if (reached > distance[at(i)]) continue;
    for (const int* j = neighbours.begin(i); j != neighbours.end(i); ++j) {
      const double next = reached + length(scan.points, i, *j);
      if (!allowed[at(*j)] || next >= distance[at(*j)]) continue;
      distance[at(*j)] = next;
      front.emplace(next, *j);
    }
  }
  return distance;
}

int ScanPieces::largest() const {
  if (areaMm2.empty()) return -1;
  return static_cast<int>(std::max_element(areaMm2.begin(), areaMm2.end()) - areaMm2.begin());
}

ScanPieces scanPieces(const Surface& scan, const Adjacency& neighbours, const std::vector<char>& in) {
  ScanPieces pieces;
  pieces.of.assign(in.size(), -1);
  const VectorXd areas = vertexAreas(scan);
  std::vector<int> stack;
  for (int first = 0; first < static_cast<int>(in.size()); ++first) {
    if (!in[at(first)] || pieces.of[at(first)] >= 0) continue;
    const int piece = static_cast<int>(pieces.areaMm2.size());
    pieces.areaMm2.push_back(0);
    pieces.of[at(first)] = piece;
    stack.assign(1, first);
    while (!stack.empty()) {
      const int i = stack.back();
      stack.pop_back();
      pieces.areaMm2.back() += areas[i];
      for (const int* j = neighbours.begin(i); j != neighbours.end(i); ++j)
        if (in[at(*j)] && pieces.of[at(*j)] < 0) {
          pieces.of[at(*j)] = piece;
          stack.push_back(*j);
        }
    }
  }
  return pieces;
}

}  // namespace falciform
