#pragma once
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform {

/// A triangle mesh that can be edited: half-edge 3 f + c runs from corner c of face f to the next corner,
/// inside f. Operations keep a manifold a manifold if their conditions hold; removed items stay in place
/// until surface() is made.
class HalfEdgeMesh {
 public:
  /// Throws InputError unless the surface is an oriented manifold, with or without boundary.
  explicit HalfEdgeMesh(const Surface& surface);

  [[nodiscard]] int halfEdges() const { return static_cast<int>(origin_.size()); }
  [[nodiscard]] int vertices() const { return static_cast<int>(position.size()); }
  [[nodiscard]] bool alive(int h) const { return origin_[at(h)] >= 0; }
  [[nodiscard]] bool vertexAlive(int v) const { return out_[at(v)] >= 0; }
  [[nodiscard]] int origin(int h) const { return origin_[at(h)]; }
  [[nodiscard]] int target(int h) const { return origin_[at(next(h))]; }
  [[nodiscard]] int opposite(int h) const { return origin_[at(previous(h))]; }
  /// The same edge in the neighbouring face; -1 on the boundary.
  [[nodiscard]] int twin(int h) const { return twin_[at(h)]; }
  [[nodiscard]] static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  [[nodiscard]] static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  [[nodiscard]] bool onBoundary(int v) const { return boundary_[at(v)] != 0; }

  /// Half-edges that leave `v`, one in each face around it, counter-clockwise.
  void spokes(int v, std::vector<int>& result) const;
  /// Vertices joined to `v` by an edge.
  void ring(int v, std::vector<int>& result) const;

  /// Cuts the edge in the middle, and the faces beside it in two.
  void split(int h);
  /// Whether the edge may be shrunk to a point with the topology kept (link condition), its origin going into
  /// its target.
  [[nodiscard]] bool collapsible(int h) const;
  /// Removes the origin of `h` and the faces beside the edge. Needs collapsible(h).
  void collapse(int h);
  /// Whether the edge may be turned: not on the boundary, and its new ends are not joined yet.
  [[nodiscard]] bool flippable(int h) const;
  /// Turns the edge inside the two faces beside it. Needs flippable(h).
  void flip(int h);

  /// Drops removed faces and vertices; ids change, their order does not.
  void compact();
  [[nodiscard]] Surface surface() const;

  std::vector<Vector3d> position;  ///< mm

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  void pair(int h, int t);

  std::vector<int> origin_, twin_;  ///< by half-edge; origin -1 = removed
  std::vector<int> out_;            ///< by vertex: a half-edge that leaves it; -1 = removed
  std::vector<char> boundary_;      ///< by vertex
};

}  // namespace falciform
