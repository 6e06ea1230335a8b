#include "Logic/Registration/PointRegistration.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <set>

#include "Logic/Core/Errors.h"
#include "Logic/Core/LandmarkPairs.h"
#include "Logic/Core/Surface.h"

namespace falciform {

namespace {

/// Weighted centroids and the 3 x 3 cross-covariance sum_i w_i (source_i - s)(target_i - t)^T.
struct Moments {
  Vector3d source = Vector3d::Zero(), target = Vector3d::Zero();
  Matrix3d cross = Matrix3d::Zero();
};

Moments momentsOf(const Points& source, const Points& target, const VectorXd& weights) {
  const VectorXd w = weights.size() > 0 ? weights : VectorXd::Ones(source.rows());
  Moments m;
  const double total = w.sum();
  m.source = source.transpose() * w / total;
  m.target = target.transpose() * w / total;
  const Points s = source.rowwise() - m.source.transpose(), t = target.rowwise() - m.target.transpose();
  m.cross = s.transpose() * w.asDiagonal() * t;
  return m;
}

Isometry3d motion(const Matrix3d& rotation, const Moments& m) {
  Isometry3d result = Isometry3d::Identity();
  result.linear() = rotation;
  result.translation() = m.target - rotation * m.source;
  return result;
}

bool sameNames(const Landmarks& a, const Landmarks& b) {
  std::set<std::string> namesA, namesB;
  for (const Landmark& p : a.points) namesA.insert(p.name);
  for (const Landmark& p : b.points) namesB.insert(p.name);
  return namesA == namesB && namesA.size() == a.points.size() && !namesA.contains("");
}

/// Standard deviations along the principal axes, largest first, mm.
Vector3d principalSpread(const Points& points) {
  const Points centred = points.rowwise() - points.colwise().mean();
  const Matrix3d covariance = centred.transpose() * centred / static_cast<double>(points.rows());
  const Vector3d values = Eigen::SelfAdjointEigenSolver<Matrix3d>(covariance).eigenvalues();
  return values.cwiseMax(0).cwiseSqrt().reverse();
}

}  // namespace

Isometry3d rigidFromMoments(const Vector3d& sourceCentroid, const Vector3d& targetCentroid,
                            const Matrix3d& cross) {
  const Eigen::JacobiSVD<Matrix3d> svd(cross, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vector3d signs = Vector3d::Ones();
  if ((svd.matrixV() * svd.matrixU().transpose()).determinant() < 0) signs.z() = -1;
  Isometry3d result = Isometry3d::Identity();
  result.linear() = svd.matrixV() * signs.asDiagonal() * svd.matrixU().transpose();
  result.translation() = targetCentroid - result.linear() * sourceCentroid;
  return result;
}

Isometry3d fitRigid(const Points& source, const Points& target, const VectorXd& weights) {
  const Moments m = momentsOf(source, target, weights);
  return rigidFromMoments(m.source, m.target, m.cross);
}

Isometry3d fitRigidHorn(const Points& source, const Points& target, const VectorXd& weights) {
  const Moments m = momentsOf(source, target, weights);
  const Matrix3d& s = m.cross;
  Matrix4d n;  // Horn 1987, section 4.A: its largest eigenvector is the unit quaternion
  n << s(0, 0) + s(1, 1) + s(2, 2), s(1, 2) - s(2, 1), s(2, 0) - s(0, 2), s(0, 1) - s(1, 0),
      s(1, 2) - s(2, 1), s(0, 0) - s(1, 1) - s(2, 2), s(0, 1) + s(1, 0), s(2, 0) + s(0, 2), s(2, 0) - s(0, 2),
      s(0, 1) + s(1, 0), -s(0, 0) + s(1, 1) - s(2, 2), s(1, 2) + s(2, 1), s(0, 1) - s(1, 0),
      s(2, 0) + s(0, 2), s(1, 2) + s(2, 1), -s(0, 0) - s(1, 1) + s(2, 2);
  const Eigen::SelfAdjointEigenSolver<Matrix4d> eigen(n);
  const Eigen::Vector4d q = eigen.eigenvectors().col(3);
  return motion(Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix(), m);
}

std::string pointRegistrationProblem(const Landmarks& source, const Landmarks& target) {
  const std::size_t n = source.points.size();
  if (n != target.points.size())
    return "landmarks: " + std::to_string(n) + " on one side and " + std::to_string(target.points.size()) +
           " on the other; give the same points on both";
  if (n < 3) return "landmarks: " + std::to_string(n) + " given; a pose needs at least 3 points";
  const Points from = positionsOf(source), to = positionsOf(target);
  if (!from.allFinite() || !to.allFinite())
    return "landmarks: a coordinate is not a finite number; place the point again";
  // Below 1 % of the length the rotation about the line is noise: refuse it.
  for (const Vector3d& spread : {principalSpread(from), principalSpread(to)})
    if (spread[1] < 0.01 * spread[0] || spread[0] <= 0)
      return "landmarks: the points lie on one line; add a point off the line";
  return {};
}

PointRegistrationResult registerPoints(const Landmarks& source, const Landmarks& target) {
  if (const std::string problem = pointRegistrationProblem(source, target); !problem.empty())
    throw InputError(problem);
  const std::size_t n = source.points.size();
  Landmarks matched = target;
  if (sameNames(source, target))
    for (std::size_t i = 0; i < n; ++i)
      matched.points[i] = *std::find_if(target.points.begin(), target.points.end(),
                                        [&](const Landmark& p) { return p.name == source.points[i].name; });
  const Points from = positionsOf(source), to = positionsOf(matched);
  const Vector3d spread = principalSpread(from);

  PointRegistrationResult result;
  result.targetFromSource = fitRigid(from, to);
  result.freByPointMm = targetErrors(from, to, result.targetFromSource);
  result.freMm = std::sqrt(result.freByPointMm.squaredNorm() / static_cast<double>(n));
  result.fleEstimateMm = result.freMm / std::sqrt(1 - 2.0 / static_cast<double>(n));
  if (spread[1] < 0.1 * spread[0])
    result.warnings.push_back("the landmarks lie nearly on a line: the turn about it is uncertain");
  if (result.freMm > 10)
    result.warnings.push_back("landmarks fit with a residual of " +
                              std::to_string(static_cast<int>(std::lround(result.freMm))) +
                              " mm: check that they are the same places in the same order");
  return result;
}

double predictedTre(const Points& source, double fleMm, const Vector3d& targetInSource) {
  const double n = static_cast<double>(source.rows());
  const Vector3d centre = source.colwise().mean();
  const Points centred = source.rowwise() - centre.transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(centred.transpose() * centred / n);
  const Vector3d variance = axes.eigenvalues(),
                 t = axes.eigenvectors().transpose() * (targetInSource - centre);
  double sum = 0;
  for (int k = 0; k < 3;
       ++k) {  // squared distances of target and fiducials (root mean square) from principal axis k
    const double d2 = t.squaredNorm() - t[k] * t[k], f2 = variance.sum() - variance[k];
    sum += d2 / f2;
  }
  return fleMm * std::sqrt((1 + sum / 3) / n);
}

VectorXd targetErrors(const Points& source, const Points& target, const Isometry3d& targetFromSource) {
  return (transformed(source, targetFromSource) - target).rowwise().norm();
}

}  // namespace falciform
