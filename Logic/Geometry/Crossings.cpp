#include "Logic/Geometry/Crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/BoxTree.h"

namespace falciform {

namespace {

constexpr std::size_t kChunk = 256;

template <class Real>
int signOf(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d, double unit) {
  using V = Eigen::Matrix<Real, 3, 1>;
  const V ad = a.cast<Real>() - d.cast<Real>(), bd = b.cast<Real>() - d.cast<Real>(),
          cd = c.cast<Real>() - d.cast<Real>();
  const V left = bd.cross(cd);
  const V most = V(bd.y(), bd.z(), bd.x()).cwiseProduct(V(cd.z(), cd.x(), cd.y())).cwiseAbs() +
                 V(bd.z(), bd.x(), bd.y()).cwiseProduct(V(cd.y(), cd.z(), cd.x())).cwiseAbs();
  const Real det = ad.dot(left), bound = static_cast<Real>(unit) * ad.cwiseAbs().dot(most);
  return det > bound ? 1 : det < -bound ? -1 : 0;
}

/// Which side of the plane a, b, c the point d is on; 0 where rounding of 64 bits hides it (Shewchuk's
/// bound).
int side(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  const int quick = signOf<double>(a, b, c, d, 7.8e-16);
  return quick != 0 ? quick : signOf<long double>(a, b, c, d, 4e-19);
}

using Triangle = std::array<Vector3d, 3>;

/// Segments pq and ab in one plane with normal n, touching included.
bool meetInPlane(const Vector3d& p, const Vector3d& q, const Vector3d& a, const Vector3d& b,
                 const Vector3d& n) {
  const auto turn = [&](const Vector3d& x, const Vector3d& y, const Vector3d& z) {
    return n.dot((y - x).cross(z - x));
  };
  const double pa = turn(p, q, a), pb = turn(p, q, b), ap = turn(a, b, p), aq = turn(a, b, q);
  if ((pa > 0 && pb > 0) || (pa < 0 && pb < 0) || (ap > 0 && aq > 0) || (ap < 0 && aq < 0)) return false;
  if (pa != 0 || pb != 0) return true;
  const Vector3d along = q - p;  // all on one line: their stretches must overlap
  const double length = along.squaredNorm(), ta = along.dot(a - p), tb = along.dot(b - p);
  return std::max(ta, tb) >= 0 && std::min(ta, tb) <= length;
}

bool insideInPlane(const Vector3d& p, const Triangle& t, const Vector3d& n) {
  for (std::size_t k = 0; k < 3; ++k)
    if (n.dot((t[(k + 1) % 3] - t[k]).cross(p - t[k])) < 0) return false;
  return true;
}

/// A place where the segment pq meets the triangle.
std::optional<Vector3d> meeting(const Vector3d& p, const Vector3d& q, const Triangle& t) {
  const int sp = side(t[0], t[1], t[2], p), sq = side(t[0], t[1], t[2], q);
  if (sp * sq > 0) return std::nullopt;
  const Vector3d n = (t[1] - t[0]).cross(t[2] - t[0]);
  if (sp == 0 && sq == 0) {
    if (insideInPlane(p, t, n)) return p;
    if (insideInPlane(q, t, n)) return q;
    for (std::size_t k = 0; k < 3; ++k)
      if (meetInPlane(p, q, t[k], t[(k + 1) % 3], n)) return Vector3d((t[k] + t[(k + 1) % 3]) / 2);
    return std::nullopt;
  }
  const int a = side(p, q, t[0], t[1]), b = side(p, q, t[1], t[2]), c = side(p, q, t[2], t[0]);
  if (std::min({a, b, c}) < 0 && std::max({a, b, c}) > 0) return std::nullopt;
  const double above = n.dot(p - t[0]), below = n.dot(q - t[0]);
  const double at = above == below ? 0.5 : std::clamp(above / (above - below), 0.0, 1.0);
  return Vector3d(p + at * (q - p));
}

class Pairs {
 public:
  Pairs(const Surface& one, const Surface& other, bool same)
      : one_(one), other_(other), same_(same), boxes_(corner(other, true), corner(other, false)) {}

  [[nodiscard]] std::vector<Crossing> find() const;

 private:
  static Points corner(const Surface& surface, bool low) {
    Points result(surface.triangles.rows(), 3);
    for (Index t = 0; t < result.rows(); ++t) {
      const Matrix3d corners = surface.points(surface.triangles.row(t).transpose().eval(), Eigen::all);
      result.row(t) = low ? corners.colwise().minCoeff().eval() : corners.colwise().maxCoeff().eval();
    }
    return result;
  }
  static Triangle triangleOf(const Surface& surface, int t) {
    Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k)
      triangle[k] = surface.points.row(surface.triangles(t, static_cast<Index>(k))).transpose();
    return triangle;
  }
  void findFor(int t, std::vector<Crossing>& found) const;
  [[nodiscard]] std::optional<Vector3d> meet(int t, int u) const;

  const Surface &one_, &other_;
  bool same_;
  BoxTree boxes_;
};

/// Edges at shared vertices are left out: they meet there by right.
std::optional<Vector3d> Pairs::meet(int t, int u) const {
  const Triangle a = triangleOf(one_, t), b = triangleOf(other_, u);
  std::array<bool, 3> sharedA{}, sharedB{};
  int shared = 0;
  if (same_)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (one_.triangles(t, static_cast<Index>(i)) == one_.triangles(u, static_cast<Index>(j))) {
          sharedA[i] = sharedB[j] = true;
          ++shared;
        }
  if (shared >= 3) return Vector3d((a[0] + a[1] + a[2]) / 3);
  if (shared == 2) {  // beside each other: only a fold flat onto itself meets
    std::size_t i = 0, j = 0;
    while (sharedA[i]) ++i;
    while (sharedB[j]) ++j;
    if (side(a[0], a[1], a[2], b[j]) != 0) return std::nullopt;
    const Vector3d edge = a[(i + 2) % 3] - a[(i + 1) % 3], from = a[(i + 1) % 3];
    const bool folded = edge.cross(a[i] - from).dot(edge.cross(b[j] - from)) > 0;
    return folded ? std::optional(Vector3d((a[i] + b[j]) / 2)) : std::nullopt;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (!sharedA[k] && !sharedA[next])
      if (const auto place = meeting(a[k], a[next], b)) return place;
    if (!sharedB[k] && !sharedB[next])
      if (const auto place = meeting(b[k], b[next], a)) return place;
  }
  return std::nullopt;
}

void Pairs::findFor(int t, std::vector<Crossing>& found) const {
  const Triangle a = triangleOf(one_, t);
  const Vector3d low = a[0].cwiseMin(a[1]).cwiseMin(a[2]), high = a[0].cwiseMax(a[1]).cwiseMax(a[2]);
  const Vector3d middle = (low + high) / 2;
  const double bound = (high - low).squaredNorm() / 4 * (1 + 1e-9) + 1e-18;
  const std::size_t first = found.size();
  boxes_.visitNear(middle, bound, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const int u = boxes_.order()[static_cast<std::size_t>(i)];
      if (same_ && u <= t) continue;
      const Triangle b = triangleOf(other_, u);
      const Vector3d lowB = b[0].cwiseMin(b[1]).cwiseMin(b[2]), highB = b[0].cwiseMax(b[1]).cwiseMax(b[2]);
      if ((lowB.array() > high.array()).any() || (highB.array() < low.array()).any()) continue;
      if (const auto place = meet(t, u)) found.push_back({t, u, *place});
    }
  });
  std::sort(found.begin() + static_cast<std::ptrdiff_t>(first), found.end(),
            [](const Crossing& x, const Crossing& y) { return x.second < y.second; });
}

std::vector<Crossing> Pairs::find() const {
  const auto count = static_cast<std::size_t>(one_.triangles.rows());
  std::vector<std::vector<Crossing>> parts((count + kChunk - 1) / kChunk);
  forEachChunk(count, kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) findFor(static_cast<int>(t), parts[begin / kChunk]);
  });
  std::vector<Crossing> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

std::vector<Crossing> selfCrossings(const Surface& surface) {
  if (surface.triangles.rows() == 0) return {};
  return Pairs(surface, surface, true).find();
}

std::vector<Crossing> crossings(const Surface& one, const Surface& other) {
  if (one.triangles.rows() == 0 || other.triangles.rows() == 0) return {};
  return Pairs(one, other, false).find();
}

}  // namespace falciform
