#pragma once
#include <Eigen/Core>

#include "Logic/Core/Types.h"

namespace falciform {

/// Logistic regression on numbers, their squares and their products: small, smooth, and fitted to its one
/// optimum, whatever the start.
struct QuadraticScorer {
  VectorXd weights;  ///< constant first, then one a term

  /// Log-odds that an example with the numbers of each row is one of those looked for.
  [[nodiscard]] VectorXd logOdds(const Eigen::MatrixXd& numbers) const;
};

/// d + d (d + 1) / 2 terms a row of d numbers: the numbers, then x_i x_j for i <= j.
[[nodiscard]] Eigen::MatrixXd quadraticTerms(const Eigen::MatrixXd& numbers);

/// Fits by Newton's method the log-odds of `yes` (0 or 1 a row), each row counted by its weight, with half
/// the `penalty` on each squared weight of a standardised term but the constant.
[[nodiscard]] QuadraticScorer fitQuadraticScorer(const Eigen::MatrixXd& numbers, const VectorXd& yes,
                                                 const VectorXd& weight, double penalty);

}  // namespace falciform
