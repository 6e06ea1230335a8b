#include "Logic/Patches/FeatureTracing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "Logic/Geometry/KdTree.h"

namespace falciform {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Cheapest paths from one vertex to all.
struct PathTree {
  std::vector<int> from;   ///< the vertex before; -1 at the source and where no path leads
  std::vector<int> order;  ///< vertices reached, cheapest first
};

PathTree cheapestPaths(const FeatureGround& ground, const VectorXd& cost, int source) {
  const auto n = static_cast<std::size_t>(ground.surface.size());
  PathTree tree{std::vector<int>(n, -1), {}};
  std::vector<double> reached(n, kFar);
  std::vector<char> done(n, 0);
  using Step = std::pair<double, int>;
  std::priority_queue<Step, std::vector<Step>, std::greater<>> front;
  reached[static_cast<std::size_t>(source)] = 0;
  front.emplace(0.0, source);
  while (!front.empty()) {
    const auto [soFar, vertex] = front.top();
    front.pop();
    if (done[static_cast<std::size_t>(vertex)]) continue;
    done[static_cast<std::size_t>(vertex)] = 1;
    tree.order.push_back(vertex);
    for (const int* next = ground.neighbours.begin(vertex); next != ground.neighbours.end(vertex); ++next) {
      const double length = (ground.surface.points.row(vertex) - ground.surface.points.row(*next)).norm();
      const double total = soFar + 0.5 * length * (cost[vertex] + cost[*next]);
      const auto at = static_cast<std::size_t>(*next);
      if (total >= reached[at]) continue;
      reached[at] = total;
      tree.from[at] = vertex;
      front.emplace(total, *next);
    }
  }
  return tree;
}

/// The vertex to which the gains along the path from the source sum up highest.
int mostGained(const FeatureGround& ground, const PathTree& tree, const VectorXd& gain) {
  VectorXd sum = VectorXd::Zero(ground.surface.size());
  int best = tree.order.front();
  for (const int v : tree.order) {
    const int before = tree.from[static_cast<std::size_t>(v)];
    if (before < 0) continue;
    const double length = (ground.surface.points.row(v) - ground.surface.points.row(before)).norm();
    sum[v] = sum[before] + 0.5 * length * (gain[v] + gain[before]);
    if (sum[v] > sum[best]) best = v;
  }
  return best;
}

VectorXd lengthsAlong(const Points& line) {
  VectorXd along = VectorXd::Zero(line.rows());
  for (Index i = 1; i < line.rows(); ++i) along[i] = along[i - 1] + (line.row(i) - line.row(i - 1)).norm();
  return along;
}

Points resampled(const Points& line) {
  if (line.rows() < 2) return line;
  const VectorXd along = lengthsAlong(line);
  const auto count = static_cast<Index>(along[along.size() - 1]) + 1;
  Points points(count, 3);
  Index segment = 0;
  for (Index i = 0; i < count; ++i) {
    const auto place = static_cast<double>(i);
    while (segment + 2 < line.rows() && along[segment + 1] < place) ++segment;
    const double length = along[segment + 1] - along[segment];
    const double share = length > 0 ? std::min(1.0, (place - along[segment]) / length) : 0;
    points.row(i) = (1 - share) * line.row(segment) + share * line.row(segment + 1);
  }
  return points;
}

}  // namespace

Points smoothedLine(const Points& polyline, double sigmaMm) {
  const Points line = resampled(polyline);
  if (line.rows() < 3 || !(sigmaMm > 0)) return line;
  const auto reach = static_cast<Index>(std::ceil(4 * sigmaMm));
  Points smooth(line.rows(), 3);
  for (Index i = 0; i < line.rows(); ++i) {
    // As much on either side, so that an end stays where it is.
    const Index sides = std::min({reach, i, line.rows() - 1 - i});
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    double weight = 0;
    for (Index j = i - sides; j <= i + sides; ++j) {
      const double w = std::exp(-0.5 * std::pow(static_cast<double>(j - i) / sigmaMm, 2));
      sum += w * line.row(j);
      weight += w;
    }
    smooth.row(i) = sum / weight;
  }
  return resampled(smooth);
}

TracedLine traceLine(const FeatureGround& ground, const VectorXd& logOdds, const VectorXd& crest,
                     const TracingPlan& plan, int axis, bool reversed) {
  const VectorXd cost = VectorXd::NullaryExpr(logOdds.size(), [&](Index i) {
    const double doubt = std::log1p(std::exp(-std::clamp(logOdds[i] + plan.costShift, -12.0, 12.0)));
    return plan.costFloor + doubt + plan.costOffCrest * (1 - crest[i]);
  });
  const VectorXd gain = (logOdds.array() + plan.gainShift).max(plan.leastGain).min(plan.mostGain).matrix();
  Index likeliest = 0;
  logOdds.maxCoeff(&likeliest);
  int start = static_cast<int>(likeliest), end = start;
  PathTree tree;
  for (int sweep = 0; sweep < 3; ++sweep) {
    start = end;
    tree = cheapestPaths(ground, cost, start);
    end = mostGained(ground, tree, gain);
  }
  std::vector<int> path;
  for (int v = end; v >= 0; v = tree.from[static_cast<std::size_t>(v)]) path.push_back(v);
  const double forward = ground.turned(path.front(), axis) - ground.turned(path.back(), axis);
  if ((forward < 0) != reversed) std::reverse(path.begin(), path.end());

  Points corners(static_cast<Index>(path.size()), 3);
  for (std::size_t i = 0; i < path.size(); ++i)
    corners.row(static_cast<Index>(i)) = ground.surface.points.row(path[i]);
  TracedLine line;
  line.points = smoothedLine(corners, plan.smoothingMm);
  line.standard.resize(line.points.rows(), 3);
  line.logOdds.resize(line.points.rows());
  const KdTree near(corners);
  for (Index i = 0; i < line.points.rows(); ++i) {
    const int v = path[static_cast<std::size_t>(near.nearest(line.points.row(i)).index)];
    line.standard.row(i) = ground.standard.row(v);
    line.logOdds[i] = logOdds[v];
  }
  return line;
}

TracedLine partOf(const TracedLine& line, Index first, Index last) {
  const Index count = last - first + 1;
  return {line.points.middleRows(first, count), line.standard.middleRows(first, count),
          line.logOdds.segment(first, count)};
}

}  // namespace falciform
