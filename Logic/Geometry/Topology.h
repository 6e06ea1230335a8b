#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform {

/// What a mesh is: closed, open, manifold, in how many pieces.
struct TopologyReport {
  Index points = 0, triangles = 0;
  int components = 0;             ///< by shared vertices, unused points not counted
  Index boundaryEdges = 0;        ///< edges of one triangle
  Index nonManifoldEdges = 0;     ///< edges of three or more triangles
  Index flippedEdges = 0;         ///< edges whose two triangles run the same way
  Index nonManifoldVertices = 0;  ///< vertices whose triangles do not form one fan
  Index degenerateTriangles = 0;  ///< two equal vertex ids
  Index unusedPoints = 0;
  Index eulerCharacteristic = 0;  ///< V - E + F of used points

  [[nodiscard]] bool closedManifold() const {
    return triangles > 0 && boundaryEdges == 0 && nonManifoldEdges == 0 && flippedEdges == 0 &&
           nonManifoldVertices == 0 && degenerateTriangles == 0;
  }
};
[[nodiscard]] TopologyReport inspectTopology(const Surface& surface);
/// "closed manifold, 1 piece, genus 0" or what is wrong, with counts.
[[nodiscard]] std::string describeTopology(const TopologyReport& report);

/// Compressed lists: items of i are values[start[i]] .. values[start[i + 1] - 1].
struct Adjacency {
  std::vector<int> start, values;
  [[nodiscard]] int count(int i) const {
    return start[static_cast<std::size_t>(i) + 1] - start[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] const int* begin(int i) const { return values.data() + start[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const int* end(int i) const { return values.data() + start[static_cast<std::size_t>(i) + 1]; }
};
/// Triangles around each of `pointCount` vertices, ascending.
[[nodiscard]] Adjacency trianglesOfVertices(const Triangles& triangles, Index pointCount);
/// Vertices joined to each vertex by an edge, ascending, without repeats.
[[nodiscard]] Adjacency neighboursOfVertices(const Triangles& triangles, Index pointCount);

/// Rows `keep` (ascending ids) of all point data; triangles with all three corners kept, re-indexed.
[[nodiscard]] Surface subset(const Surface& surface, const std::vector<int>& keep);
/// The piece (by shared vertices) with the largest area, unused points dropped; a cloud is returned as it is.
[[nodiscard]] Surface largestPiece(const Surface& surface);

}  // namespace falciform
