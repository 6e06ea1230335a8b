#include "Logic/Geometry/ScannerSide.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "Logic/Geometry/Measures.h"

namespace falciform {

namespace {

/// Evenly spread unit vectors on the upper half sphere (Fibonacci spiral).
Vector3d spiral(int i, int count) {
  const double z = (i + 0.5) / count, turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

/// Cells of a square grid that the points fall into when seen along `view`: the area they show.
int shownCells(const Points& centred, const Vector3d& view, double cell, std::vector<char>& seen) {
  const Vector3d u = view.unitOrthogonal(), v = view.cross(u);
  const auto side = static_cast<Index>(std::sqrt(static_cast<double>(seen.size())));
  std::fill(seen.begin(), seen.end(), char{0});
  int count = 0;
  for (Index i = 0; i < centred.rows(); ++i) {
    const auto x =
        std::clamp<Index>(static_cast<Index>(centred.row(i).dot(u) / cell) + side / 2, 0, side - 1);
    const auto y =
        std::clamp<Index>(static_cast<Index>(centred.row(i).dot(v) / cell) + side / 2, 0, side - 1);
    char& place = seen[static_cast<std::size_t>(y * side + x)];
    count += place == 0;
    place = 1;
  }
  return count;
}

/// Up to sign, the direction that shows most of a cloud. What one scanner saw overlaps itself least from
/// where it stood.
Vector3d widestView(const Points& points) {
  constexpr int kDirections = 300, kSide = 64;
  constexpr Index kEnough = 4000;
  const Index stride = std::max<Index>(1, points.rows() / kEnough);
  Points some((points.rows() + stride - 1) / stride, 3);
  for (Index i = 0; i < some.rows(); ++i) some.row(i) = points.row(i * stride);
  some.rowwise() -= some.colwise().mean().eval();
  const double reach = some.rowwise().norm().maxCoeff();
  if (!(reach > 0)) return Vector3d::UnitZ();
  std::vector<char> seen(kSide * kSide);
  Vector3d best = Vector3d::UnitZ();
  int most = -1;
  for (int i = 0; i < kDirections; ++i) {
    const Vector3d view = spiral(i, kDirections);
    const int shown = shownCells(some, view, 2 * reach / kSide, seen);
    if (shown > most) {
      most = shown;
      best = view;
    }
  }
  return best;
}

}  // namespace

Vector3d seenFrom(const Surface& scan) {
  if (scan.size() < 3) return Vector3d::UnitZ();
  Vector3d sum = Vector3d::Zero();
  for (Index t = 0; t < scan.triangles.rows(); ++t) {
    const Vector3d a = scan.points.row(scan.triangles(t, 0)), b = scan.points.row(scan.triangles(t, 1)),
                   c = scan.points.row(scan.triangles(t, 2));
    sum += (b - a).cross(c - a);
  }
  // A closed surface has no mean normal; what little is left of it is rounding.
  if (scan.triangles.rows() > 0 && sum.norm() > 0.02 * 2 * area(scan)) return sum.normalized();

  const Vector3d view = widestView(scan.points);
  const Points centred = scan.points.rowwise() - scan.points.colwise().mean();
  const VectorXd height = centred * view;
  const VectorXd rim = (centred - height * view.transpose()).rowwise().squaredNorm();
  // Organs bulge towards the scanner: where the rim lies lower than the middle, the direction points at the
  // scanner.
  const double falls = (height.array() * (rim.array() - rim.mean())).sum();
  return falls > 0 ? Vector3d(-view) : view;
}

}  // namespace falciform
