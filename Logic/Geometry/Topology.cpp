#include "Logic/Geometry/Topology.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace falciform {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

bool degenerate(const Triangles& t, Index f) {
  return t(f, 0) == t(f, 1) || t(f, 1) == t(f, 2) || t(f, 2) == t(f, 0);
}

/// Disjoint sets of vertices, joined by triangles.
class Pieces {
 public:
  Pieces(const Triangles& triangles, Index pointCount) : parent_(static_cast<std::size_t>(pointCount)) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (Index f = 0; f < triangles.rows(); ++f) {
      join(triangles(f, 0), triangles(f, 1));
      join(triangles(f, 0), triangles(f, 2));
    }
  }
  int root(int i) {
    while (parent_[at(i)] != i) i = parent_[at(i)] = parent_[at(parent_[at(i)])];
    return i;
  }

 private:
  /// The lowest id is the root, so that a piece's name does not depend on the order of its triangles.
  void join(int a, int b) {
    const auto [low, high] = std::minmax({root(a), root(b)});
    parent_[at(high)] = low;
  }
  std::vector<int> parent_;
};

/// The other two corners of each triangle around a vertex, in the triangle's direction: the edges of its
/// link.
using Link = std::vector<std::pair<int, int>>;

/// Counts the edges from `v` to higher vertices by kind: each edge is met once, at its lower end.
void countEdges(int v, const Link& link, std::vector<std::pair<int, int>>& spokes, Index& edges,
                TopologyReport& report) {
  spokes.clear();  // (other end, +1 for v -> other or -1 for the reverse)
  for (const auto& [next, last] : link) {
    if (next > v) spokes.emplace_back(next, 1);
    if (last > v) spokes.emplace_back(last, -1);
  }
  std::sort(spokes.begin(), spokes.end());
  for (std::size_t i = 0, end = 0; i < spokes.size(); i = end) {
    int direction = 0;
    for (end = i; end < spokes.size() && spokes[end].first == spokes[i].first; ++end)
      direction += spokes[end].second;
    ++edges;
    if (end - i == 1) ++report.boundaryEdges;
    if (end - i == 2 && direction != 0) ++report.flippedEdges;
    if (end - i > 2) ++report.nonManifoldEdges;
  }
}

/// Whether the link is one closed loop or one open path, whatever the triangles' directions.
bool oneFan(const Link& link, std::vector<std::pair<int, int>>& ends, std::vector<char>& seen) {
  ends.clear();  // (vertex of the link, edge of the link), sorted: a vertex must stand there once or twice
  for (std::size_t e = 0; e < link.size(); ++e) {
    ends.emplace_back(link[e].first, static_cast<int>(e));
    ends.emplace_back(link[e].second, static_cast<int>(e));
  }
  std::sort(ends.begin(), ends.end());
  std::size_t joints = 0;
  for (std::size_t i = 0, end = 0; i < ends.size(); i = end) {
    for (end = i; end < ends.size() && ends[end].first == ends[i].first; ++end) {
    }
    if (end - i > 2) return false;
    joints += end - i == 2;
  }
  // n edges with every vertex of degree <= 2 are loops and paths; walk from edge 0 (both ways) and see if all
  // are met.
  seen.assign(link.size(), 0);
  seen[0] = 1;
  std::size_t met = 1;
  for (const int from : {link[0].first, link[0].second}) {
    int vertex = from, edge = 0;
    for (;;) {
      const auto place = std::lower_bound(ends.begin(), ends.end(), std::make_pair(vertex, -1));
      const bool joint = place + 1 != ends.end() && (place + 1)->first == vertex;
      if (!joint) break;
      const int other = place->second == edge ? (place + 1)->second : place->second;
      if (seen[at(other)]) break;
      seen[at(other)] = 1;
      ++met;
      vertex = link[at(other)].first == vertex ? link[at(other)].second : link[at(other)].first;
      edge = other;
    }
  }
  return met == link.size() && joints + 1 >= link.size();
}

}  // namespace

TopologyReport inspectTopology(const Surface& surface) {
  const Triangles& t = surface.triangles;
  TopologyReport report;
  report.points = surface.points.rows();
  report.triangles = t.rows();
  for (Index f = 0; f < t.rows(); ++f) report.degenerateTriangles += degenerate(t, f);

  const Adjacency around = trianglesOfVertices(t, report.points);
  Pieces pieces(t, report.points);
  Index edges = 0;
  Link link;
  std::vector<std::pair<int, int>> scratch;
  std::vector<char> seen;
  for (int v = 0; v < report.points; ++v) {
    if (around.count(v) == 0) {
      ++report.unusedPoints;
      continue;
    }
    report.components += pieces.root(v) == v;
    link.clear();
    for (const int* f = around.begin(v); f != around.end(v); ++f) {
      if (degenerate(t, *f)) continue;
      const int corner = t(*f, 0) == v ? 0 : t(*f, 1) == v ? 1 : 2;
      link.emplace_back(t(*f, (corner + 1) % 3), t(*f, (corner + 2) % 3));
    }
    if (link.empty()) continue;
    countEdges(v, link, scratch, edges, report);
    report.nonManifoldVertices += !oneFan(link, scratch, seen);
  }
  report.eulerCharacteristic =
      report.points - report.unusedPoints - edges + report.triangles - report.degenerateTriangles;
  return report;
}

std::string describeTopology(const TopologyReport& r) {
  if (r.triangles == 0) return "no triangles, " + std::to_string(r.points) + " points";
  const std::string pieces = std::to_string(r.components) + (r.components == 1 ? " piece" : " pieces");
  if (r.closedManifold()) {
    const Index handles = (2 * r.components - r.eulerCharacteristic) / 2;
    return "closed manifold, " + pieces + ", genus " + std::to_string(handles);
  }
  std::string text = pieces;
  const auto add = [&](Index count, const char* one, const char* many) {
    if (count > 0) text += ", " + std::to_string(count) + ' ' + (count == 1 ? one : many);
  };
  add(r.boundaryEdges, "boundary edge", "boundary edges");
  add(r.nonManifoldEdges, "edge of three or more triangles", "edges of three or more triangles");
  add(r.flippedEdges, "edge between triangles of opposite orientation",
      "edges between triangles of opposite orientation");
  add(r.nonManifoldVertices, "vertex where sheets touch", "vertices where sheets touch");
  add(r.degenerateTriangles, "degenerate triangle", "degenerate triangles");
  return text;
}

Adjacency trianglesOfVertices(const Triangles& triangles, Index pointCount) {
  Adjacency lists;
  lists.start.assign(static_cast<std::size_t>(pointCount) + 1, 0);
  const auto eachCorner = [&](auto&& visit) {
    for (Index f = 0; f < triangles.rows(); ++f)
      for (int c = 0; c < 3; ++c) {
        assert(triangles(f, c) >= 0 && triangles(f, c) < pointCount);
        const bool repeated =
            (c > 0 && triangles(f, c) == triangles(f, 0)) || (c > 1 && triangles(f, c) == triangles(f, 1));
        if (!repeated) visit(triangles(f, c), static_cast<int>(f));
      }
  };
  eachCorner([&](int v, int) { ++lists.start[at(v) + 1]; });
  std::partial_sum(lists.start.begin(), lists.start.end(), lists.start.begin());
  lists.values.resize(at(lists.start.back()));
  std::vector<int> next(lists.start.begin(), lists.start.end() - 1);
  eachCorner([&](int v, int f) { lists.values[at(next[at(v)]++)] = f; });
  return lists;
}

Adjacency neighboursOfVertices(const Triangles& triangles, Index pointCount) {
  const Adjacency around = trianglesOfVertices(triangles, pointCount);
  Adjacency lists;
  lists.start.assign(1, 0);
  lists.start.reserve(static_cast<std::size_t>(pointCount) + 1);
  lists.values.reserve(static_cast<std::size_t>(triangles.rows()) * 3);
  std::vector<int> ring;
  for (int v = 0; v < pointCount; ++v) {
    ring.clear();
    for (const int* f = around.begin(v); f != around.end(v); ++f)
      for (int c = 0; c < 3; ++c)
        if (triangles(*f, c) != v) ring.push_back(triangles(*f, c));
    std::sort(ring.begin(), ring.end());
    lists.values.insert(lists.values.end(), ring.begin(), std::unique(ring.begin(), ring.end()));
    lists.start.push_back(static_cast<int>(lists.values.size()));
  }
  return lists;
}

Surface subset(const Surface& surface, const std::vector<int>& keep) {
  Surface part;
  part.frame = surface.frame;
  part.patchNames = surface.patchNames;
  const auto rows = [&](const auto& from, auto& to) {
    if (from.rows() != 0) to = from(keep, Eigen::all);
  };
  rows(surface.points, part.points);
  rows(surface.normals, part.normals);
  rows(surface.colours, part.colours);
  rows(surface.textureAt, part.textureAt);
  part.texture = surface.texture;
  if (!surface.patch.empty())
    for (const int i : keep) part.patch.push_back(surface.patch[at(i)]);
  for (const auto& [name, values] : surface.arrays) part.arrays[name] = values(keep);

  std::vector<int> now(static_cast<std::size_t>(surface.size()), -1);
  for (std::size_t i = 0; i < keep.size(); ++i) now[at(keep[i])] = static_cast<int>(i);
  part.triangles.resize(surface.triangles.rows(), 3);
  Index kept = 0;
  for (Index f = 0; f < surface.triangles.rows(); ++f) {
    const Vector3i corners(now[at(surface.triangles(f, 0))], now[at(surface.triangles(f, 1))],
                           now[at(surface.triangles(f, 2))]);
    if (corners.minCoeff() >= 0) part.triangles.row(kept++) = corners.transpose();
  }
  part.triangles.conservativeResize(kept, 3);
  return part;
}

Surface largestPiece(const Surface& surface) {
  if (surface.triangles.rows() == 0) return surface;
  Pieces pieces(surface.triangles, surface.size());
  std::vector<double> area(static_cast<std::size_t>(surface.size()), 0.0);
  std::vector<char> used(area.size(), 0);
  for (Index f = 0; f < surface.triangles.rows(); ++f) {
    const auto t = surface.triangles.row(f);
    const Vector3d a = surface.points.row(t[0]), b = surface.points.row(t[1]), c = surface.points.row(t[2]);
    area[at(pieces.root(t[0]))] += (b - a).cross(c - a).norm() / 2;
    for (int corner = 0; corner < 3; ++corner) used[at(t[corner])] = 1;
  }
  const int largest = static_cast<int>(std::max_element(area.begin(), area.end()) - area.begin());
  std::vector<int> keep;
  for (int v = 0; v < surface.size(); ++v)
    if (used[at(v)] && pieces.root(v) == pieces.root(largest)) keep.push_back(v);
  return subset(surface, keep);
}

}  // namespace falciform
