#include "Logic/Geometry/SphereFit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

constexpr int kIterations = 100;
constexpr double kStopMm = 1e-10;  // the last step; Gauss-Newton needs about five
constexpr int kDraws = 300;        // (2/3)^4 of the draws miss all outliers: 300 fail with 1e-28
constexpr double kTukey = 4.685;   // 95 % efficiency for normal errors (Holland, Welsch 1977)
constexpr double kMadToSd = 1.4826;
constexpr double kFlattest = 1e-6;  // of thickness against width: below, four points lie in one plane

void check(const Points& points) {
  if (points.rows() < 4)
    throw InputError("a sphere through " + std::to_string(points.rows()) +
                     " points is not defined; give at least 4");
  if (!points.allFinite())
    throw InputError("a point of the sphere has a coordinate that is not a finite number; drop it");
}

/// (|p|^2 - 2 p.c + |c|^2 - r^2) is linear in c and in r^2 - |c|^2. Empty if the points lie in one plane.
std::optional<SphereFit> algebraic(const Points& points) {
  const Vector3d middle = points.colwise().mean();
  const Points q = points.rowwise() - middle.transpose();
  const double size = std::sqrt(q.rowwise().squaredNorm().mean());
  if (!(size > 0)) return {};
  Eigen::MatrixX4d a(q.rows(), 4);
  a << 2 * q / size, VectorXd::Ones(q.rows());
  const VectorXd b = q.rowwise().squaredNorm() / (size * size);
  const Eigen::Matrix4d normal = a.transpose() * a;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(normal);
  if (eigen.eigenvalues()[0] < kFlattest * kFlattest * eigen.eigenvalues()[3]) return {};
  const Eigen::Vector4d x =
      eigen.eigenvectors() *
      (eigen.eigenvectors().transpose() * (a.transpose() * b)).cwiseQuotient(eigen.eigenvalues());
  SphereFit fit;
  fit.centre = middle + size * x.head<3>();
  fit.radiusMm = size * std::sqrt(std::max(x[3] + x.head<3>().squaredNorm(), 0.0));
  return fit;
}

VectorXd distances(const Points& points, const SphereFit& fit) {
  return (points.rowwise() - fit.centre.transpose()).rowwise().norm().array() - fit.radiusMm;
}

double medianOf(VectorXd values) {
  auto* middle = values.data() + values.size() / 2;
  std::nth_element(values.data(), middle, values.data() + values.size());
  return *middle;
}

double robustSd(const VectorXd& e) { return std::max(kMadToSd * medianOf(e.cwiseAbs()), 1e-9); }

VectorXd tukeyWeights(const VectorXd& e, double sd) {
  return (1 - (e.array() / (kTukey * sd)).square().min(1.0)).square();
}

/// One Gauss-Newton step of sum_i w_i (|p_i - c| - r)^2; also the inverse normal matrix. Length of the step.
double step(const Points& points, const VectorXd& weights, bool freeRadius, SphereFit& fit,
            Eigen::Matrix4d& inverse) {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (Index i = 0; i < points.rows(); ++i) {
    const Vector3d d = points.row(i).transpose() - fit.centre;
    const double length = d.norm();
    if (!(length > 0)) continue;
    Eigen::Vector4d row;  // minus the derivative of the distance by (c, r)
    row << d / length, freeRadius ? 1.0 : 0.0;
    normal += weights[i] * row * row.transpose();
    right += weights[i] * (length - fit.radiusMm) * row;
  }
  if (!freeRadius) normal(3, 3) = 1;
  inverse = normal.completeOrthogonalDecomposition().pseudoInverse();
  const Eigen::Vector4d move = inverse * right;
  fit.centre += move.head<3>();
  fit.radiusMm += move[3];
  return move.norm();
}

/// Gauss-Newton to the end; Tukey's scale is estimated anew for the first twenty steps and then held, so that
/// the energy has one minimum to go to.
SphereFit refine(const Points& points, SphereFit fit, bool freeRadius, bool robust) {
  constexpr int kScaleSteps = 20;
  VectorXd weights = VectorXd::Ones(points.rows());
  Eigen::Matrix4d inverse;
  double sd = 0;
  for (fit.iterations = 1; fit.iterations <= kIterations; ++fit.iterations) {
    if (robust) {
      const VectorXd e = distances(points, fit);
      if (fit.iterations <= kScaleSteps) sd = robustSd(e);
      weights = tukeyWeights(e, sd);
    }
    const double moved = step(points, weights, freeRadius, fit, inverse);
    if (!std::isfinite(moved)) break;
    fit.converged = moved < kStopMm && (!robust || fit.iterations > kScaleSteps || sd <= 1e-9);
    if (fit.converged) break;
  }
  const VectorXd e = distances(points, fit);
  const double count = weights.sum(), sum = weights.dot(e.cwiseAbs2());
  fit.used = (weights.array() > 0).count();
  fit.rmsMm = std::sqrt(sum / count);
  const double variance = sum / std::max(count - (freeRadius ? 4 : 3), 1.0);
  fit.centreErrorMm = std::sqrt(variance * inverse.topLeftCorner<3, 3>().trace());
  return fit;
}

[[noreturn]] void refuseFlat() {
  throw InputError("the points of the sphere lie in one plane; take points of a larger part of it");
}

}  // namespace

SphereFit fitSphereAlgebraic(const Points& points) {
  check(points);
  auto fit = algebraic(points);
  if (!fit) refuseFlat();
  fit->rmsMm = std::sqrt(distances(points, *fit).squaredNorm() / static_cast<double>(points.rows()));
  fit->used = points.rows();
  fit->converged = true;
  return *fit;
}

SphereFit fitSphere(const Points& points, std::optional<double> radiusMm) {
  SphereFit start = fitSphereAlgebraic(points);
  if (radiusMm) start.radiusMm = *radiusMm;
  start.converged = false;
  return refine(points, start, !radiusMm, false);
}

SphereFit fitSphereRobust(const Points& points, std::optional<double> radiusMm) {
  check(points);
  std::mt19937 draws(1);  // its raw output is the same everywhere
  std::optional<SphereFit> best;
  double lowest = 0;
  const auto n = static_cast<std::uint32_t>(points.rows());
  for (int draw = 0; draw < kDraws; ++draw) {
    Points four(4, 3);
    for (int k = 0; k < 4; ++k) four.row(k) = points.row(static_cast<Index>(draws() % n));
    auto fit = algebraic(four);
    if (!fit) continue;
    if (radiusMm) fit->radiusMm = *radiusMm;
    const double score = medianOf(distances(points, *fit).cwiseAbs());
    if (!best || score < lowest) best = fit, lowest = score;
  }
  if (!best) refuseFlat();
  return refine(points, *best, !radiusMm, true);
}

}  // namespace falciform
