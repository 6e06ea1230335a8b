#pragma once
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform {

/// The vertices joined to each vertex by an edge, without repeats, and the normal there: made in one go on
/// all threads, for loops over every vertex that have a few milliseconds. Vertices in the same place are one
/// where the surface is stored triangle by triangle.
class VertexRings {
 public:
  explicit VertexRings(const Surface& surface);

  [[nodiscard]] const int* begin(int vertex) const {
    return values_.data() + start_[static_cast<std::size_t>(vertex)];
  }
  [[nodiscard]] const int* end(int vertex) const {
    return begin(vertex) + count_[static_cast<std::size_t>(vertex)];
  }
  /// Unit, outward: the mean of the triangles around, by area; zero where there is none.
  [[nodiscard]] Vector3d normal(int vertex) const { return normals_.row(vertex); }
  /// The vertex that stands for all in the same place.
  [[nodiscard]] int representative(int vertex) const {
    return same_.empty() ? vertex : same_[static_cast<std::size_t>(vertex)];
  }

 private:
  void unite(const Points& points, int vertex);

  std::vector<int> same_;           ///< empty: every vertex stands for itself
  std::vector<int> start_, count_;  ///< the ring of v: values_[start_[v]], count_[v] of them
  std::vector<int> values_;
  Points normals_;
};

}  // namespace falciform
