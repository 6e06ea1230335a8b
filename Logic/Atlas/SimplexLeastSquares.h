#pragma once
#include "Logic/Core/Types.h"

namespace falciform {

/// The x that minimises x' H x / 2 - g' x with x >= 0 and sum(x) <= 1, by an active set in the manner of
/// Lawson and Hanson (1974): exact, up to rounding, in finitely many steps. `hessian`: K x K, symmetric,
/// positive definite. K values.
[[nodiscard]] VectorXd simplexLeastSquares(const Eigen::MatrixXd& hessian, const VectorXd& gradient);

}  // namespace falciform
