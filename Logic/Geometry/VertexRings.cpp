#include "Logic/Geometry/VertexRings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/SamePlaces.h"

namespace falciform {

VertexRings::VertexRings(const Surface& surface) {
  const auto n = static_cast<std::size_t>(surface.size());
  // A mesh has half as many vertices as triangles; one stored triangle by triangle has three times as many.
  if (surface.size() > surface.triangles.rows()) same_ = firstInSamePlace(surface.points);
  const auto id = [&](Index t, int corner) { return representative(surface.triangles(t, corner)); };

  // First the two other corners of each triangle around a vertex, then in their place the ring.
  start_.assign(n + 1, 0);
  for (Index t = 0; t < surface.triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c) start_[static_cast<std::size_t>(id(t, c)) + 1] += 2;
  for (std::size_t v = 0; v < n; ++v) start_[v + 1] += start_[v];
  values_.resize(static_cast<std::size_t>(6 * surface.triangles.rows()));
  count_.assign(n, 0);
  for (Index t = 0; t < surface.triangles.rows(); ++t) {
    const int a = id(t, 0), b = id(t, 1), c = id(t, 2);
    const auto put = [&](int v, int next, int previous) {
      const auto i = static_cast<std::size_t>(v);
      int* pair = values_.data() + start_[i] + count_[i];
      pair[0] = next;
      pair[1] = previous;
      count_[i] += 2;
    };
    put(a, b, c);
    put(b, c, a);
    put(c, a, b);
  }
  normals_.resize(surface.size(), 3);
  forEachChunk(n, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) unite(surface.points, static_cast<int>(v));
  });
}

void VertexRings::unite(const Points& points, int vertex) {
  const auto i = static_cast<std::size_t>(vertex);
  int* pairs = values_.data() + start_[i];
  const int corners = count_[i] / 2;
  const Vector3d here = points.row(vertex);
  Vector3d normal = Vector3d::Zero();
  for (int k = 0; k < corners; ++k) {
    const Vector3d next = points.row(pairs[2 * k]), previous = points.row(pairs[2 * k + 1]);
    normal += (next - here).cross(previous - here);
  }
  const double length = normal.norm();
  normals_.row(vertex) = length > 0 ? Vector3d(normal / length) : Vector3d::Zero();

  // Around an inner vertex every neighbour is the next corner of one triangle and the previous of another:
  // the previous ones add only what lies on a border.
  constexpr int kUsual = 32;
  std::array<int, kUsual> few;
  std::vector<int> many;
  int* others = few.data();
  if (corners > kUsual) {
    many.resize(static_cast<std::size_t>(corners));
    others = many.data();
  }
  for (int k = 0; k < corners; ++k) others[k] = pairs[2 * k + 1];
  int count = 0;
  const auto take = [&](int v) {
    if (v != vertex && std::find(pairs, pairs + count, v) == pairs + count) pairs[count++] = v;
  };
  for (int k = 0; k < corners; ++k) take(pairs[2 * k]);  // never writes past what it reads
  for (int k = 0; k < corners; ++k) take(others[k]);
  count_[i] = count;
}

}  // namespace falciform
