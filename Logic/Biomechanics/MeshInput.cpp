#include "Logic/Biomechanics/MeshInput.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <set>

#include "Logic/Core/Errors.h"
#include "Logic/Core/PlaceText.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/SamePlaces.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {

namespace {

std::string counted(Index count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::array<int, 3> turnedSmallestFirst(std::array<int, 3> t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// The surface with points joined and triangles that are void or there already left out.
Surface joined(const Surface& surface, const std::string& what, std::vector<std::string>& warnings) {
  const std::vector<int> first = firstInSamePlace(surface.points);
  std::set<std::array<int, 3>> known;
  std::vector<std::array<int, 3>> kept;
  std::vector<int> newId(static_cast<std::size_t>(surface.size()), -1);
  Index flat = 0, twice = 0, moved = 0;
  for (Index i = 0; i < surface.size(); ++i) moved += first[static_cast<std::size_t>(i)] != i;
  for (Index t = 0; t < surface.triangles.rows(); ++t) {
    std::array<int, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = first[static_cast<std::size_t>(surface.triangles(t, static_cast<Index>(k)))];
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
      ++flat;
      continue;
    }
    if (!known.insert(turnedSmallestFirst(corners)).second) {
      ++twice;
      continue;
    }
    for (const int c : corners) newId[static_cast<std::size_t>(c)] = 0;
    kept.push_back(corners);
  }
  std::vector<int> used;
  for (std::size_t i = 0; i < newId.size(); ++i)
    if (newId[i] == 0) {
      newId[i] = static_cast<int>(used.size());
      used.push_back(static_cast<int>(i));
    }
  if (moved > 0)
    warnings.push_back(what + ": " + counted(moved, "double point", "double points") + " joined");
  if (twice > 0)
    warnings.push_back(what + ": " + counted(twice, "double triangle", "double triangles") + " dropped");
  if (flat > 0)
    warnings.push_back(what + ": " + counted(flat, "triangle", "triangles") + " without area dropped");
  Surface result;
  result.frame = surface.frame;
  result.points = surface.points(used, Eigen::all);
  result.triangles.resize(std::ssize(kept), 3);
  for (Index t = 0; t < result.triangles.rows(); ++t)
    for (Index k = 0; k < 3; ++k)
      result.triangles(t, k) =
          newId[static_cast<std::size_t>(kept[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)])];
  return result;
}

/// The middle of the first edge, by triangle, that has one triangle only.
Vector3d firstOpenEdge(const Surface& surface) {
  std::map<std::pair<int, int>, int> count;
  const auto visit = [&](auto&& act) {
    for (Index t = 0; t < surface.triangles.rows(); ++t)
      for (Index k = 0; k < 3; ++k) {
        const int a = surface.triangles(t, k), b = surface.triangles(t, (k + 1) % 3);
        act(std::pair<int, int>(std::minmax(a, b)));
      }
  };
  visit([&](const std::pair<int, int>& edge) { ++count[edge]; });
  std::pair<int, int> open{-1, -1};
  visit([&](const std::pair<int, int>& edge) {
    if (open.first < 0 && count[edge] == 1) open = edge;
  });
  return (surface.points.row(open.first) + surface.points.row(open.second)).transpose() / 2;
}

}  // namespace

std::vector<Surface> piecesOf(const Surface& surface) {
  const Adjacency neighbours = neighboursOfVertices(surface.triangles, surface.size());
  std::vector<char> seen(static_cast<std::size_t>(surface.size()), 0);
  std::vector<Surface> pieces;
  for (int start = 0; start < static_cast<int>(seen.size()); ++start) {
    if (seen[static_cast<std::size_t>(start)] != 0 || neighbours.count(start) == 0) continue;
    std::vector<int> piece{start};
    seen[static_cast<std::size_t>(start)] = 1;
    for (std::size_t next = 0; next < piece.size(); ++next) {
      const int from = piece[next];
      for (const int* to = neighbours.begin(from); to != neighbours.end(from); ++to) {
        if (seen[static_cast<std::size_t>(*to)] != 0) continue;
        seen[static_cast<std::size_t>(*to)] = 1;
        piece.push_back(*to);
      }
    }
    std::sort(piece.begin(), piece.end());
    pieces.push_back(subset(surface, piece));
  }
  return pieces;
}

Surface closedSurface(const Surface& surface, const std::string& what, Pieces pieces,
                      std::vector<std::string>& warnings) {
  checkSurface(surface, what);
  if (surface.triangles.rows() == 0)
    throw InputError(what + " has no triangles; give a closed triangle surface");
  Surface result = joined(surface, what, warnings);
  if (result.triangles.rows() == 0)
    throw InputError(what + " has no triangle with an area; give a closed triangle surface");
  TopologyReport topology = inspectTopology(result);
  if (topology.components > 1 && pieces != Pieces::KeepAll) {
    if (pieces == Pieces::Refuse)
      throw InputError(what + " is in " + std::to_string(topology.components) +
                       " pieces that do not hang together; keep the largest one (--largest-piece) or export "
                       "the liver alone");
    warnings.push_back(what + ": the largest of " + std::to_string(topology.components) + " pieces kept");
    result = largestPiece(result);
    topology = inspectTopology(result);
  }
  if (topology.boundaryEdges > 0)
    throw InputError(what + " is open: " + counted(topology.boundaryEdges, "edge has", "edges have") +
                     " one triangle only, the first at " + placeText(firstOpenEdge(result)) +
                     "; close its holes, or import it from a label map");
  if (!topology.closedManifold())
    throw InputError(what + " does not bound a body: " + describeTopology(topology) +
                     "; import it from a label map, or export it again");
  const double volume = signedVolume(result);
  if (volume < 0) {
    result.triangles.col(1).swap(result.triangles.col(2));
    warnings.push_back(what + ": its triangles faced inwards and were turned round");
  }
  return result;
}

}  // namespace falciform
