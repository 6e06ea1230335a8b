#include "Logic/Patches/PatchPath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace falciform {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();
constexpr int kMostKnots = 100;         // of a path that is pulled taut
constexpr double kLargestStepMm = 0.5;  // between the places of the answer

using Path = std::vector<SurfacePlace>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A* over the points, from and to places inside triangles.
class Search {
 public:
  Search(const BrushSurface& surface, const VectorXd& cost)
      : surface_(surface),
        points_(surface.shape().points),
        cost_(cost),
        least_(cost.size() > 0 ? cost.minCoeff() : 1),
        length_(at(static_cast<int>(points_.rows())), kUnknown),
        before_(length_.size(), -1) {}

  /// Points from start to end.
  std::vector<int> run(const SurfacePlace& from, const SurfacePlace& to) {
    goal_ = to.point;
    for (const int corner : cornersOf(from)) reach(corner, stepTo(corner, from.point), -1);
    const std::vector<int> ends = cornersOf(to);
    double best = kUnknown;
    int last = -1;
    while (!front_.empty()) {
      const auto [bound, length, point] = front_.top();
      if (bound >= best) break;
      front_.pop();
      if (length > length_[at(point)]) continue;  // has been improved since
      if (std::find(ends.begin(), ends.end(), point) != ends.end() && length + stepTo(point, goal_) < best) {
        best = length + stepTo(point, goal_);
        last = point;
      }
      surface_.neighbours(point, joined_);
      for (const int next : joined_)
        reach(next, length + (points_.row(next) - points_.row(point)).norm() * between(point, next), point);
    }
    std::vector<int> way;
    for (int point = last; point >= 0; point = before_[at(point)]) way.push_back(point);
    std::reverse(way.begin(), way.end());
    return way;
  }

 private:
  [[nodiscard]] std::vector<int> cornersOf(const SurfacePlace& place) const {
    if (place.triangle < 0) return {place.vertex};
    const auto row = surface_.shape().triangles.row(place.triangle);
    return {row[0], row[1], row[2]};
  }
  [[nodiscard]] double costAt(int point) const { return cost_.size() > 0 ? cost_[point] : 1; }
  [[nodiscard]] double between(int a, int b) const { return 0.5 * (costAt(a) + costAt(b)); }
  [[nodiscard]] double stepTo(int point, const Vector3d& place) const {
    return (points_.row(point).transpose() - place).norm() * costAt(point);
  }
  void reach(int point, double length, int before) {
    if (!(length < length_[at(point)])) return;
    length_[at(point)] = length;
    before_[at(point)] = before;
    front_.emplace(length + (points_.row(point).transpose() - goal_).norm() * least_, length, point);
  }

  using Entry = std::tuple<double, double, int>;
  const BrushSurface& surface_;
  const Points& points_;
  const VectorXd& cost_;
  double least_;
  Vector3d goal_ = Vector3d::Zero();
  std::vector<double> length_;
  std::vector<int> before_, joined_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front_;
};

/// `count` + 1 places at equal distances along the polyline.
Points evenly(const Points& line, int count) {
  VectorXd along(line.rows());
  along[0] = 0;
  for (Index i = 1; i < line.rows(); ++i) along[i] = along[i - 1] + (line.row(i) - line.row(i - 1)).norm();
  Points knots(count + 1, 3);
  Index piece = 1;
  for (int k = 0; k <= count; ++k) {
    const double want = along[along.size() - 1] * k / count;
    while (piece < line.rows() - 1 && along[piece] < want) ++piece;
    const double length = along[piece] - along[piece - 1];
    const double share = length > 0 ? std::clamp((want - along[piece - 1]) / length, 0.0, 1.0) : 0;
    knots.row(k) = (1 - share) * line.row(piece - 1) + share * line.row(piece);
  }
  return knots;
}

/// Moves each knot towards the middle of its neighbours and back onto the surface until nothing moves: what
/// remains of a taut string's pull is across the surface, so the line is a geodesic.
void pullTaut(Points& knots, const TriangleTree& tree) {
  const Index n = knots.rows() - 1;
  if (n < 2) return;
  const double spacing = (knots.row(n) - knots.row(0)).norm() / static_cast<double>(n) + 1e-9;
  const double overshoot = 2 / (1 + std::sin(3.14159265358979 / static_cast<double>(n)));  // Young 1954
  const int sweeps = static_cast<int>(3 * n);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double most = 0;
    for (Index k = 1; k < n; ++k) {
      const Vector3d old = knots.row(k).transpose();
      const Vector3d middle = 0.5 * (knots.row(k - 1) + knots.row(k + 1)).transpose();
      const ClosestPlace place = tree.closest(old + overshoot * (middle - old));
      knots.row(k) = place.point.transpose();
      most = std::max(most, (place.point - old).norm());
    }
    if (most < 1e-4 * spacing) return;
  }
}

/// No pair further apart than the others, and none of their middles far off the surface: else the line has
/// slipped through the body, as it may where that is thinner than a step.
bool liesOnSurface(const Points& knots, const TriangleTree& tree) {
  double longest = 0, sum = 0;
  for (Index k = 1; k < knots.rows(); ++k) {
    const double step = (knots.row(k) - knots.row(k - 1)).norm();
    longest = std::max(longest, step);
    sum += step;
  }
  const double mean = sum / static_cast<double>(knots.rows() - 1);
  if (longest > 2.5 * mean) return false;
  for (Index k = 1; k < knots.rows(); ++k)
    if (tree.closest(0.5 * (knots.row(k) + knots.row(k - 1)).transpose()).distance > 0.3 * mean) return false;
  return true;
}

SurfacePlace placeOn(const TriangleTree& tree, const Vector3d& point) {
  const ClosestPlace closest = tree.closest(point);
  SurfacePlace place{closest.triangle, -1, closest.point};
  Index corner = 0;
  closest.barycentric.maxCoeff(&corner);
  place.vertex = tree.vertexOf(closest.triangle, static_cast<int>(corner));
  return place;
}

}  // namespace

Path shortestPath(const BrushSurface& surface, const TriangleTree* tree, const SurfacePlace& from,
                  const SurfacePlace& to, const VectorXd& cost) {
  const Points& points = surface.shape().points;
  const bool mesh = !surface.isCloud();
  if (mesh && from.triangle == to.triangle) return {from, to};
  const std::vector<int> way = Search(surface, cost).run(from, to);
  if (way.empty()) return {};
  if (!mesh) {
    Path path;
    for (const int point : way) path.push_back({-1, point, points.row(point).transpose()});
    return path;
  }
  Points line(static_cast<Index>(way.size()) + 2, 3);
  line.row(0) = from.point.transpose();
  for (std::size_t i = 0; i < way.size(); ++i) line.row(static_cast<Index>(i) + 1) = points.row(way[i]);
  line.row(line.rows() - 1) = to.point.transpose();
  // About one knot a point that the line passes, so that none of a finer mesh's shape is cut off.
  Points knots = evenly(line, std::clamp(static_cast<int>(way.size()), 2, kMostKnots));
  if (cost.size() == 0) {
    Points taut = knots;
    pullTaut(taut, *tree);
    if (liesOnSurface(taut, *tree)) knots = taut;
  } else {
    knots = line;
  }
  const double length =
      (knots.bottomRows(knots.rows() - 1) - knots.topRows(knots.rows() - 1)).rowwise().norm().sum();
  const int steps = std::max(1, static_cast<int>(std::ceil(length / kLargestStepMm)));
  const Points dense = evenly(knots, steps);
  Path path{from};
  for (Index k = 1; k < steps; ++k) path.push_back(placeOn(*tree, dense.row(k).transpose()));
  path.push_back(to);
  return path;
}

double lengthOf(const Path& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += (path[i].point - path[i - 1].point).norm();
  return length;
}

std::vector<int> pointsAlong(const BrushSurface& surface, const Path& path, double halfWidth) {
  std::vector<char> chosen(at(static_cast<int>(surface.shape().size())), 0);
  double since = kUnknown;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0) since += (path[i].point - path[i - 1].point).norm();
    // Discs a fifth of their radius apart leave notches of half a percent of it between them.
    const bool last = i + 1 == path.size();
    const double ahead = last ? 0 : (path[i + 1].point - path[i].point).norm();
    if (since + ahead <= 0.2 * halfWidth && !last) continue;
    since = 0;
    for (const int id : surface.under(path[i].triangle, path[i].point, Vector3d::Zero(), halfWidth))
      chosen[at(id)] = 1;
  }
  std::vector<int> ids;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i] != 0) ids.push_back(static_cast<int>(i));
  return ids;
}

}  // namespace falciform
