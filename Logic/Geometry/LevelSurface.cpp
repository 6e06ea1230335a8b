#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "Logic/Geometry/GridField.h"

// Marching tetrahedra (Doi, Koide 1991) on Kuhn's cut of the cube into six: it fits from cube to cube, so the
// surface closes, and each triangle stays in its tetrahedron, so none cuts another.

namespace falciform {

namespace {

/// Corners of a cube by bits x 1, y 2, z 4: each path from 0 to 7 along three axes is a tetrahedron.
constexpr std::array<std::array<int, 4>, 6> kPaths{
    {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}}};
/// A point is kept this share of its edge away from the ends, so that no triangle is a needle's point.
constexpr double kNearest = 0.05;

class Marcher {
 public:
  Marcher(const GridField& field, double level) : field_(field), level_(level) {}
  void march(int x, int y, int z);
  [[nodiscard]] Surface surface() const;

 private:
  struct Corner {
    std::size_t index;
    Vector3d place;
    double value;
  };
  [[nodiscard]] Corner corner(int x, int y, int z, int bits) const;
  int pointBetween(const Corner& a, const Corner& b);
  void triangle(int a, int b, int c, const Vector3d& outwards);

  const GridField& field_;
  double level_;
  std::unordered_map<std::uint64_t, int> pointOf_;
  std::vector<Vector3d> points_;
  std::vector<std::array<int, 3>> triangles_;
};

Marcher::Corner Marcher::corner(int x, int y, int z, int bits) const {
  const int cx = x + (bits & 1), cy = y + (bits >> 1 & 1), cz = z + (bits >> 2);
  const std::size_t i = field_.index(cx, cy, cz);
  return {i, field_.place(cx, cy, cz), field_.values[i] - level_};
}

int Marcher::pointBetween(const Corner& a, const Corner& b) {
  if (a.index > b.index) return pointBetween(b, a);
  const auto [found, isNew] = pointOf_.try_emplace(static_cast<std::uint64_t>(a.index) << 32 | b.index,
                                                   static_cast<int>(points_.size()));
  if (isNew) {
    const double at = std::clamp(a.value / (a.value - b.value), kNearest, 1 - kNearest);
    points_.push_back(a.place + at * (b.place - a.place));
  }
  return found->second;
}

void Marcher::triangle(int a, int b, int c, const Vector3d& outwards) {
  const auto at = [&](int i) -> const Vector3d& { return points_[static_cast<std::size_t>(i)]; };
  if ((at(b) - at(a)).cross(at(c) - at(a)).dot(outwards) < 0) std::swap(b, c);
  triangles_.push_back({a, b, c});
}

void Marcher::march(int x, int y, int z) {
  std::array<Corner, 8> cube;
  int inside = 0;
  for (int bits = 0; bits < 8; ++bits) {
    cube[static_cast<std::size_t>(bits)] = corner(x, y, z, bits);
    if (std::isnan(cube[static_cast<std::size_t>(bits)].value)) return;
    inside += cube[static_cast<std::size_t>(bits)].value < 0;
  }
  if (inside == 0 || inside == 8) return;
  for (const auto& path : kPaths) {
    std::array<const Corner*, 4> in{}, out{};
    std::size_t ins = 0, outs = 0;
    Vector3d outwards = Vector3d::Zero();
    for (const int bits : path) {
      const Corner& c = cube[static_cast<std::size_t>(bits)];
      (c.value < 0 ? in[ins++] : out[outs++]) = &c;
    }
    if (ins == 0 || outs == 0) continue;
    for (std::size_t k = 0; k < ins; ++k) outwards -= in[k]->place / static_cast<double>(ins);
    for (std::size_t k = 0; k < outs; ++k) outwards += out[k]->place / static_cast<double>(outs);
    if (ins == 2) {
      const int p = pointBetween(*in[0], *out[0]), q = pointBetween(*in[0], *out[1]),
                r = pointBetween(*in[1], *out[1]), s = pointBetween(*in[1], *out[0]);
      triangle(p, q, r, outwards);
      triangle(p, r, s, outwards);
    } else {
      const Corner& one = ins == 1 ? *in[0] : *out[0];
      const auto& others = ins == 1 ? out : in;
      triangle(pointBetween(one, *others[0]), pointBetween(one, *others[1]), pointBetween(one, *others[2]),
               outwards);
    }
  }
}

Surface Marcher::surface() const {
  Surface surface;
  surface.points.resize(std::ssize(points_), 3);
  for (Index i = 0; i < surface.size(); ++i)
    surface.points.row(i) = points_[static_cast<std::size_t>(i)].transpose();
  surface.triangles.resize(std::ssize(triangles_), 3);
  for (Index t = 0; t < surface.triangles.rows(); ++t)
    for (Index k = 0; k < 3; ++k)
      surface.triangles(t, k) = triangles_[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)];
  return surface;
}

}  // namespace

Surface levelSurface(const GridField& field, double level) {
  Marcher marcher(field, level);
  for (int z = 0; z + 1 < field.counts.z(); ++z)
    for (int y = 0; y + 1 < field.counts.y(); ++y)
      for (int x = 0; x + 1 < field.counts.x(); ++x) marcher.march(x, y, z);
  return marcher.surface();
}

}  // namespace falciform
