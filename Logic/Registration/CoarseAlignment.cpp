#include "Logic/Registration/CoarseAlignment.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace falciform {

namespace {

constexpr double kRobustMm = 10, kScoreScaleMm = 5;
constexpr double kPointShare = 0.1;       // point-to-point beside point-to-plane, so that far points pull too
constexpr double kLeastAgreement = 0.05;  // weight of a point that faces the wrong way
constexpr double kLargestTurn = 0.35;     // radians a step
constexpr double kStillMm = 0.1;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

struct Pair {
  Vector3d moved, toTarget;  ///< mm
  Vector3d normal;           ///< of the target
  double squared = 0, agreement = 0;
  int label = 0, own = -1;
};

/// Normal equations of a small turn about `centre` and shift, in the order turn, shift.
class Equations {
 public:
  explicit Equations(const Vector3d& centre) : centre_(centre) {}

  void addPlane(const Pair& p, double weight) {
    Vector6d j;
    j << (p.moved - centre_).cross(p.normal), p.normal;
    matrix_.selfadjointView<Eigen::Lower>().rankUpdate(j, weight);
    right_ += weight * p.normal.dot(p.toTarget) * j;
  }
  void addPoint(const Vector3d& moved, const Vector3d& toTarget, double weight) {
    const Vector3d arm = moved - centre_;
    matrix_.topLeftCorner<3, 3>() +=
        weight * (arm.squaredNorm() * Matrix3d::Identity() - arm * arm.transpose());
    Matrix3d cross;  // -[arm]x, rows: shift, columns: turn
    cross << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
    matrix_.bottomLeftCorner<3, 3>() += weight * cross;
    matrix_.diagonal().tail<3>().array() += weight;
    right_.head<3>() += weight * arm.cross(toTarget);
    right_.tail<3>() += weight * toTarget;
  }
  [[nodiscard]] Isometry3d solve() {
    matrix_.diagonal().head<3>().array() += 1e-9 * matrix_.diagonal().head<3>().sum() + 1e-9;
    matrix_.diagonal().tail<3>().array() += 1e-9 * matrix_.diagonal().tail<3>().sum() + 1e-9;
    const Vector6d x = matrix_.selfadjointView<Eigen::Lower>().ldlt().solve(right_);
    const double angle = x.head<3>().norm(), keep = std::min(1.0, kLargestTurn / std::max(angle, 1e-12));
    Isometry3d step = Isometry3d::Identity();
    step.translate(centre_ + keep * x.tail<3>());
    if (angle > 0) step.rotate(Eigen::AngleAxisd(keep * angle, x.head<3>() / angle));
    step.translate(-centre_);
    return step;
  }

 private:
  Vector3d centre_;
  Matrix6d matrix_ = Matrix6d::Zero();
  Vector6d right_ = Vector6d::Zero();
};

/// (1 + r^2)^-2 (Geman and McClure): as Welsch's weight, without its exponential.
double robustWeight(double squared, double scale) {
  const double r = 1 + squared / (scale * scale);
  return 1 / (r * r);
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Pair pairOf(const PreparedPreop& preop, const ScanSample& sample, Index i, const Isometry3d& pose) {
  Pair p;
  p.moved = pose * sample.points.row(i).transpose();
  const int near = preop.grid().closest(p.moved);
  p.toTarget = preop.surface().points.row(near).transpose() - p.moved;
  p.normal = preop.normals().row(near);
  p.squared = p.toTarget.squaredNorm();
  p.agreement = p.normal.dot(pose.linear() * sample.normals.row(i).transpose());
  p.label = sample.labels[static_cast<std::size_t>(i)];
  if (p.label > 0) p.own = preop.grid(p.label).closest(p.moved);
  return p;
}

}  // namespace

void alignCoarsely(const PreparedPreop& preop, const ScanSample& sample, const CoarsePull& pull,
                   int iterations, StartPose& pose) {
  const auto n = static_cast<std::size_t>(sample.size());
  std::vector<Pair> pairs(n);
  std::vector<double> squared(n), own;
  const double decay =
      pull.first > 0 ? std::pow(pull.last / pull.first, 1.0 / std::max(1, iterations / 2)) : 1;
  double ownWeight = pull.first;
  const Vector3d middle = sample.points.colwise().mean();
  const double reach = (sample.points.rowwise() - middle.transpose()).rowwise().norm().maxCoeff();
  for (int step = 0; step < iterations; ++step) {
    own.clear();
    for (std::size_t i = 0; i < n; ++i) {
      pairs[i] = pairOf(preop, sample, static_cast<Index>(i), pose.preopFromScan);
      squared[i] = pairs[i].squared;
      if (pairs[i].own >= 0)
        own.push_back((preop.surface().points.row(pairs[i].own).transpose() - pairs[i].moved).squaredNorm());
    }
    const double scale = std::max(kRobustMm, 2 * std::sqrt(median(squared)));
    const double ownScale = own.empty() ? 1 : std::max(kRobustMm, 2 * std::sqrt(median(own)));
    const Vector3d centre = pose.preopFromScan * middle;
    Equations equations(centre);
    for (const Pair& p : pairs) {
      if (pull.surface > 0) {
        const double weight =
            pull.surface * robustWeight(p.squared, scale) * std::clamp(p.agreement, kLeastAgreement, 1.0);
        equations.addPlane(p, weight);
        equations.addPoint(p.moved, p.toTarget, kPointShare * weight);
      }
      if (p.own < 0 || ownWeight <= 0) continue;
      const Vector3d toOwn = preop.surface().points.row(p.own).transpose() - p.moved;
      equations.addPoint(p.moved, toOwn, ownWeight * robustWeight(toOwn.squaredNorm(), ownScale));
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

void scoreCoarsely(const PreparedPreop& preop, const ScanSample& sample, StartPose& pose) {
  const auto term = [](double squared) { return squared / (squared + kScoreScaleMm * kScoreScaleMm); };
  double sum = 0, weights = 0;
  for (Index i = 0; i < sample.size(); ++i) {
    const Pair p = pairOf(preop, sample, i, pose.preopFromScan);
    sum += p.agreement < 0 ? 1 : term(p.squared);
    weights += 1;
    if (p.own < 0) continue;
    sum += 2 * term((preop.surface().points.row(p.own).transpose() - p.moved).squaredNorm());
    weights += 2;
  }
  pose.score = sum / weights;
}

}  // namespace falciform
