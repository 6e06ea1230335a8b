#include "Logic/Patches/FeatureModel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "Logic/Geometry/KdTree.h"

namespace falciform {

namespace {

constexpr double kMiddleRight = 0.7, kMiddleLeft = -1.3;  ///< standard; where along the margin a notch may be
constexpr double kNotchSideMm = 20;
constexpr Index kSlopeMm = 20;  ///< to either side; points lie 1 mm apart

/// Height and depth of the margin as functions of the place from right to left: linear between its points.
class MarginProfile {
 public:
  explicit MarginProfile(const Points& turned) : points_(turned.rows(), 3) {
    std::vector<Index> order(static_cast<std::size_t>(turned.rows()));
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return turned(a, 0) < turned(b, 0); });
    for (std::size_t i = 0; i < order.size(); ++i) points_.row(static_cast<Index>(i)) = turned.row(order[i]);
  }
  [[nodiscard]] double at(double x, int axis) const {
    const Index n = points_.rows();
    Index low = 0, high = n;
    while (low < high) {
      const Index middle = (low + high) / 2;
      if (points_(middle, 0) < x)
        low = middle + 1;
      else
        high = middle;
    }
    if (low == 0) return points_(0, axis);
    if (low == n) return points_(n - 1, axis);
    const double width = points_(low, 0) - points_(low - 1, 0);
    const double share = width > 0 ? (x - points_(low - 1, 0)) / width : 0;
    return (1 - share) * points_(low - 1, axis) + share * points_(low, axis);
  }

 private:
  Points points_;
};

/// Rotation from the surface's frame to (right, front, head), told by the ground's own points.
Points turnedLine(const FeatureGround& ground, const Points& line) {
  return line * ground.axes.rows.transpose();
}

}  // namespace

VectorXd crestOfGround(const FeatureGround& ground, bool valley) {
  // tanh(k x 8 mm) x peak as described: 0.75 and more is as sharp as need be (a radius of 8 mm).
  return (ground.descriptors.col(valley ? 16 : 14).array() / 0.75).min(1.0).matrix();
}

TracedLine traceMargin(const FeatureGround& ground, const FeatureModel& model) {
  return traceLine(ground, model.ridge.logOdds(ground.descriptors), crestOfGround(ground, false), {}, 0,
                   false);
}

TracedLine traceSmoothMargin(const FeatureGround& ground, const FeatureModel& model) {
  TracingPlan plan;
  plan.costFloor = 0.1;
  plan.costShift = -1;
  return traceLine(ground, model.ridge.logOdds(ground.descriptors), crestOfGround(ground, false), plan, 0,
                   false);
}

Eigen::MatrixXd endPlaces(const FeatureGround& ground, const TracedLine& margin) {
  const Points line = turnedLine(ground, margin.points);
  const Index last = line.rows() - 1;
  Eigen::MatrixXd places(line.rows(), 2);
  for (Index i = 0; i <= last; ++i) {
    const Eigen::RowVector3d way =
        line.row(std::min(i + kSlopeMm, last)) - line.row(std::max<Index>(i - kSlopeMm, 0));
    places.row(i) << margin.standard(i, 0), way.norm() > 0 ? way.z() / way.norm() : 0;
  }
  return places;
}

LineEnds ridgeEnds(const FeatureGround& ground, const TracedLine& margin, const FeatureModel& model) {
  return likelyEnds(margin, endPlaces(ground, margin), ground.sizeMm, model.ridgeEnds);
}

Eigen::MatrixXd grooveDescriptors(const FeatureGround& ground, const TracedLine& margin) {
  std::vector<int> middle;
  for (Index i = 0; i < margin.points.rows(); ++i)
    if (margin.standard(i, 0) > kMiddleLeft && margin.standard(i, 0) < kMiddleRight)
      middle.push_back(static_cast<int>(i));
  const Points line = turnedLine(ground, margin.points);
  const KdTree tree = middle.empty() ? KdTree(line) : KdTree(line, middle);
  const MarginProfile profile(line);
  const Index n = ground.turned.rows();
  Eigen::MatrixXd numbers(n, kDescriptors + 7);
  numbers.leftCols(kDescriptors) = ground.descriptors;
  for (Index i = 0; i < n; ++i) {
    const Eigen::RowVector3d p = ground.turned.row(i);
    const Neighbour nearest = tree.nearest(p.transpose());
    const double x = p.x(), z = profile.at(x, 2);
    const double notch = z - 0.5 * (profile.at(x - kNotchSideMm, 2) + profile.at(x + kNotchSideMm, 2));
    numbers.row(i).tail(7) << std::sqrt(nearest.squaredDistance), p - line.row(nearest.index), p.z() - z,
        p.y() - profile.at(x, 1), notch;
  }
  numbers.rightCols(7) /= ground.sizeMm;
  return numbers;
}

}  // namespace falciform
