#include "Logic/Atlas/AtlasCoefficients.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "Logic/Atlas/SimplexLeastSquares.h"

namespace falciform {

AtlasCoefficients tikhonovCoefficients(const Atlas& atlas, const ModalEquations& equations, double lambda) {
  const Eigen::MatrixXd& members = atlas.coefficients;  // C
  const Eigen::MatrixXd products = members.transpose() * members;
  const Eigen::LDLT<Eigen::MatrixXd> factor(products);
  const double meanDiagonal = equations.square.cwiseProduct(products).sum() /
                              static_cast<double>(members.rows());  // of S'WS = C A C'
  const double betaSquared =
      lambda * meanDiagonal * equations.relativeError * equations.relativeError;  // Eq. (V.17)
  // The modes span the members, so C'C has an inverse; multiplied through by it, nothing is ill-conditioned
  // where beta is 0: (A C'C + beta^2 I) x = right, c = C'C x, phi = C x.
  const Eigen::MatrixXd penalty =
      factor.solve(Eigen::MatrixXd::Identity(products.rows(), products.cols())) * betaSquared;
  AtlasCoefficients found;
  found.modes = (equations.square + penalty).ldlt().solve(equations.right);  // Eq. (V.16)
  found.members = members * factor.solve(found.modes);
  return found;
}

AtlasCoefficients constrainedCoefficients(const Atlas& atlas, const ModalEquations& equations) {
  const Eigen::MatrixXd& members = atlas.coefficients;
  Eigen::MatrixXd hessian = members * equations.square * members.transpose();
  // Members of one place differ by their push alone: a hair of damping says which of equal answers is taken.
  constexpr double kHair = 1e-9;
  hessian.diagonal().array() += kHair * std::max(hessian.diagonal().mean(), 1e-12);
  AtlasCoefficients found;
  found.members = simplexLeastSquares(hessian, members * equations.right);
  found.modes = members.transpose() * found.members;
  return found;
}

MemberStatistics::MemberStatistics(const Atlas& atlas, double varianceShare)
    : mean_(atlas.coefficients.colwise().mean().transpose()) {
  const Eigen::MatrixXd spread = atlas.coefficients.rowwise() - mean_.transpose();
  const double freedom = std::max(1.0, static_cast<double>(spread.rows() - 1));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(spread.transpose() * spread / freedom);
  const VectorXd values = eigen.eigenvalues().cwiseMax(0).reverse();
  const double all = values.sum();
  Index kept = 0;
  for (double held = 0; kept < values.size() && values[kept] > 1e-12 * all && held < varianceShare * all;
       ++kept)
    held += values[kept];
  variances_ = values.head(kept);
  components_ = eigen.eigenvectors().rowwise().reverse().leftCols(kept);
}

AtlasCoefficients MemberStatistics::mostProbable(const ModalEquations& equations) const {
  AtlasCoefficients found;
  found.modes = mean_;
  if (components() == 0) return found;
  const double precision = 1 / (equations.pointVariance * equations.pointsPerSample);
  Eigen::MatrixXd square = components_.transpose() * equations.square * components_ * precision;
  square.diagonal() += variances_.cwiseInverse();
  const VectorXd right = components_.transpose() * (equations.right - equations.square * mean_) * precision;
  found.modes += components_ * square.ldlt().solve(right);
  return found;
}

}  // namespace falciform
