#include "Logic/Registration/ThinPlateSpline.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Core/Surface.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Registration/PointRegistration.h"

namespace falciform {

namespace {

/// -|a_i - b_k|, conditionally positive definite.
Eigen::MatrixXd kernel(const Points& a, const Points& b) {
  Eigen::MatrixXd values(a.rows(), b.rows());
  for (Index k = 0; k < b.rows(); ++k) values.col(k) = -(a.rowwise() - b.row(k)).rowwise().norm();
  return values;
}

}  // namespace

Points ThinPlateSpline::operator()(const Points& points) const {
  Points moved(points.rows(), 3);
  forEachChunk(static_cast<std::size_t>(points.rows()), 512, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) {
      Eigen::RowVector3d place = (rigid_ * points.row(i).transpose()).transpose();
      for (Index k = 0; k < knots_.rows(); ++k)
        place -= (points.row(i) - knots_.row(k)).norm() * weights_.row(k);
      moved.row(i) = place;
    }
  });
  return moved;
}

ThinPlateFit::ThinPlateFit(const Points& source, const Points& knots) : source_(source), knots_(knots) {
  const Index k = knots.rows();
  const Eigen::RowVector3d middle = centroid(knots).transpose();
  unit_ = std::sqrt((knots.rowwise() - middle).rowwise().squaredNorm().mean());
  if (k < 2 || unit_ <= 0) return;
  // On weights that sum to 0, -|x - y| is a positive definite kernel, and what it moves stays bounded.
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(Eigen::MatrixXd::Ones(k, 1));
  free_ = (qr.householderQ() * Eigen::MatrixXd::Identity(k, k)).rightCols(k - 1);
  bend_.resize(source.rows(), k);
  bend_ << kernel(source, knots) / unit_ * free_, VectorXd::Ones(source.rows());
  energy_ = Eigen::MatrixXd::Zero(k, k);
  energy_.topLeftCorner(k - 1, k - 1) = free_.transpose() * (kernel(knots, knots) / unit_) * free_;
}

ThinPlateSpline ThinPlateFit::fit(const Points& target, const VectorXd& weights, double stiffness) const {
  Isometry3d rigid = fitRigid(source_, target, weights);
  if (free_.cols() == 0 || std::isinf(stiffness)) return {rigid, Points(0, 3), Points(0, 3)};
  const Points left = target - transformed(source_, rigid);
  const VectorXd shares = weights / weights.sum();
  const Eigen::MatrixXd weighted = shares.asDiagonal() * bend_;
  const Eigen::MatrixXd normal = bend_.transpose() * weighted + stiffness * energy_;
  const Eigen::MatrixXd solved = normal.ldlt().solve(weighted.transpose() * left);
  rigid.pretranslate(Vector3d(solved.row(solved.rows() - 1).transpose()));
  return {rigid, knots_, free_ * solved.topRows(solved.rows() - 1) / unit_};
}

}  // namespace falciform
