#include "Logic/Registration/CoarseAlignment.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "Logic/Core/Median.h"

namespace falciform {

namespace {

constexpr double kGridCellMm = 4, kMarginMm = 40, kLabelMarginMm = 60;
constexpr float kRobustMm = 10, kScoreScaleMm = 5;
constexpr float kPointShare = 0.1F;       // point-to-point beside point-to-plane, so that far points pull too
constexpr float kLeastAgreement = 0.05F;  // weight of a point that faces the wrong way
constexpr double kLargestTurn = 0.35;     // radians a step
constexpr double kStillMm = 0.3;
using Eigen::Vector3f;

struct Pose {
  Eigen::Matrix3f rotation;
  Vector3f translation;
  explicit Pose(const Isometry3d& pose)
      : rotation(pose.linear().cast<float>()), translation(pose.translation().cast<float>()) {}
  [[nodiscard]] Vector3f operator*(const Vector3f& p) const { return rotation * p + translation; }
};

/// A sample point where the pose puts it, and what it is drawn to; one that is not labelled has no `toOwn`.
struct Pair {
  Vector3f moved, toTarget = Vector3f::Zero(), normal = Vector3f::Zero(), toOwn = Vector3f::Zero();
  float squared = 0, agreement = 0, ownSquared = -1;
};

/// A sample in single precision.
struct Cloud {
  Eigen::Matrix3Xf points, normals;
  explicit Cloud(const ScanSample& sample)
      : points(sample.points.transpose().cast<float>()), normals(sample.normals.transpose().cast<float>()) {}
};

Pair pairOf(const CoarseTarget& target, const ScanSample& sample, const Cloud& cloud, std::size_t i,
            const Pose& pose, bool surface) {
  Pair p;
  p.moved = pose * cloud.points.col(static_cast<Index>(i));
  if (surface) {
    const CoarseTarget::Place& near = target.closest(p.moved);
    p.toTarget = near.point - p.moved;
    p.normal = near.normal;
    p.squared = p.toTarget.squaredNorm();
    p.agreement = near.normal.dot(pose.rotation * cloud.normals.col(static_cast<Index>(i)));
  }
  if (sample.labels[i] > 0) {
    p.toOwn = target.closestOf(sample.labels[i], p.moved).point - p.moved;
    p.ownSquared = p.toOwn.squaredNorm();
  }
  return p;
}

/// Normal equations of a small turn about `centre` and a shift.
class Equations {
 public:
  explicit Equations(Vector3f centre) : centre_(std::move(centre)) {}

  void addPlane(const Pair& p, float weight) {
    Row j;  // padded to whole vectors
    j << (p.moved - centre_).cross(p.normal), p.normal, p.normal.dot(p.toTarget), 0;
    planes_ += (weight * j) * j.transpose();
  }
  void addPoint(const Vector3f& moved, const Vector3f& toTarget, float weight) {
    const Vector3f arm = moved - centre_, weighted = weight * arm;
    total_ += weight;
    arms_ += weighted;
    products_ += weighted * arm.transpose();
    pulls_ += weight * toTarget;
    twists_ += weighted.cross(toTarget);
  }
  /// The motion, turned by at most kLargestTurn.
  [[nodiscard]] Isometry3d solve() const {
    Eigen::Matrix<double, 6, 6> matrix = planes_.topLeftCorner<6, 6>().cast<double>();
    Eigen::Matrix<double, 6, 1> right = planes_.block<6, 1>(0, 6).cast<double>();
    const Matrix3d products = products_.cast<double>();
    const Vector3d arms = arms_.cast<double>(), centre = centre_.cast<double>();
    matrix.topLeftCorner<3, 3>() += products.trace() * Matrix3d::Identity() - products;
    Matrix3d cross;  // -[arms]x, rows: shift, columns: turn
    cross << 0, arms.z(), -arms.y(), -arms.z(), 0, arms.x(), arms.y(), -arms.x(), 0;
    matrix.bottomLeftCorner<3, 3>() += cross;
    matrix.topRightCorner<3, 3>() += cross.transpose();
    matrix.diagonal().tail<3>().array() += total_;
    right.head<3>() += twists_.cast<double>();
    right.tail<3>() += pulls_.cast<double>();
    // Points in a line or a single point leave a motion open: it is not made.
    matrix.diagonal().head<3>().array() += 1e-6 * matrix.diagonal().head<3>().sum() + 1e-9;
    matrix.diagonal().tail<3>().array() += 1e-6 * matrix.diagonal().tail<3>().sum() + 1e-9;
    const Eigen::Matrix<double, 6, 1> x = matrix.ldlt().solve(right);
    const double angle = x.head<3>().norm(), keep = std::min(1.0, kLargestTurn / std::max(angle, 1e-12));
    Isometry3d step = Isometry3d::Identity();
    step.translate(centre + keep * x.tail<3>());
    if (angle > 0) step.rotate(Eigen::AngleAxisd(keep * angle, x.head<3>() / angle));
    step.translate(-centre);
    return step;
  }

 private:
  using Row = Eigen::Matrix<float, 8, 1>;
  Vector3f centre_;
  Eigen::Matrix<float, 8, 8> planes_ = Eigen::Matrix<float, 8, 8>::Zero();
  Eigen::Matrix3f products_ = Eigen::Matrix3f::Zero();
  Vector3f arms_ = Vector3f::Zero(), pulls_ = Vector3f::Zero(), twists_ = Vector3f::Zero();
  float total_ = 0;
};

/// (1 + r^2)^-2 (Geman and McClure): as Welsch's weight, without its exponential.
float robustWeight(float squared, float scale) {
  const float r = 1 + squared / (scale * scale);
  return 1 / (r * r);
}

/// The scale beyond which a point counts little: twice the median, and not below kRobustMm.
float robustScale(std::vector<float>& squared) {
  return std::max(kRobustMm, 2 * std::sqrt(medianInPlace(squared)));
}

}  // namespace

CoarseTarget::CoarseTarget(const Surface& preop, const Points& normals) {
  for (Index i = 0; i < preop.size(); ++i)
    places_.push_back(
        {preop.points.row(i).transpose().cast<float>(), normals.row(i).transpose().cast<float>()});
  std::vector<int> rows(static_cast<std::size_t>(preop.size()));
  std::iota(rows.begin(), rows.end(), 0);
  all_ = ClosestPointGrid(preop.points, rows, kGridCellMm, kMarginMm);
  for (const int label : patchLabels(preop))
    labels_[label] = ClosestPointGrid(preop.points, pointsOfPatch(preop, label), kGridCellMm, kLabelMarginMm);
}

void alignCoarsely(const CoarseTarget& target, const ScanSample& sample, const CoarsePull& pull,
                   int iterations, StartPose& pose) {
  const auto n = static_cast<std::size_t>(sample.size());
  const Cloud cloud(sample);
  std::vector<Pair> pairs(n);
  std::vector<float> squared, ownSquared;
  const double decay = pull.first > 0 ? std::pow(pull.last / pull.first, 2.0 / std::max(2, iterations)) : 1;
  double ownWeight = pull.first;
  const Vector3d middle = sample.points.colwise().mean();
  const double reach = (sample.points.rowwise() - middle.transpose()).rowwise().norm().maxCoeff();
  for (int step = 0; step < iterations; ++step) {
    const Pose here(pose.preopFromScan);
    squared.clear();
    ownSquared.clear();
    for (std::size_t i = 0; i < n; ++i) {
      pairs[i] = pairOf(target, sample, cloud, i, here, pull.surface);
      if (pull.surface) squared.push_back(pairs[i].squared);
      if (pairs[i].ownSquared >= 0) ownSquared.push_back(pairs[i].ownSquared);
    }
    const float scale = robustScale(squared), ownScale = robustScale(ownSquared);
    const Vector3d centre = pose.preopFromScan * middle;
    Equations equations(centre.cast<float>());
    for (const Pair& p : pairs) {
      if (pull.surface) {
        const float weight = robustWeight(p.squared, scale) * std::clamp(p.agreement, kLeastAgreement, 1.0F);
        equations.addPlane(p, weight);
        equations.addPoint(p.moved, p.toTarget, kPointShare * weight);
      }
      if (p.ownSquared >= 0)
        equations.addPoint(p.moved, p.toOwn,
                           static_cast<float>(ownWeight) * robustWeight(p.ownSquared, ownScale));
    }
    const Isometry3d motion = equations.solve();
    pose.preopFromScan = motion * pose.preopFromScan;
    const double moved = (motion * centre - centre).norm() +
                         reach * (motion.linear() - Matrix3d::Identity()).norm() / std::sqrt(2.0);
    if (moved < kStillMm && ownWeight <= pull.last * 1.01) break;
    ownWeight = std::max(pull.last, ownWeight * decay);
  }
  pose.preopFromScan.linear() =
      Eigen::Quaterniond(pose.preopFromScan.linear()).normalized().toRotationMatrix();
}

void scoreCoarsely(const CoarseTarget& target, const ScanSample& sample, StartPose& pose) {
  const auto term = [](float squared) { return squared / (squared + kScoreScaleMm * kScoreScaleMm); };
  const Cloud cloud(sample);
  const Pose here(pose.preopFromScan);
  double sum = 0, weights = 0;
  for (std::size_t i = 0; i < sample.labels.size(); ++i) {
    const Pair p = pairOf(target, sample, cloud, i, here, true);
    sum += p.agreement < 0 ? 1 : term(p.squared);
    weights += 1;
    if (p.ownSquared < 0) continue;
    sum += 2 * term(p.ownSquared);
    weights += 2;
  }
  pose.score = sum / weights;
}

}  // namespace falciform
