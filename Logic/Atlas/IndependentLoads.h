#pragma once
#include <Eigen/Core>

namespace falciform {

/// Loads of a linear problem, one a row, as sums of as few as possible of them: loads = coefficients * basis.
struct IndependentLoads {
  Eigen::MatrixXd basis;         ///< K x d, linearly independent: what has to be solved
  Eigen::MatrixXd coefficients;  ///< M x K
};

/// K is the rank of `loads` (M x d). Where as many columns differ from zero as the rank, the basis are units
/// along them and the coefficients the loads' own numbers, exact; else some of the loads themselves, chosen
/// by pivoting. Loads that are all zero have K = 0.
[[nodiscard]] IndependentLoads independentLoads(const Eigen::MatrixXd& loads);

}  // namespace falciform
