#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// Rows of `maps` (vertices of one target liver x cases) that every case covers: those without NaN. The
/// overlap region of thesis Fig. IV.3.
[[nodiscard]] std::vector<Index> commonCoverage(const Eigen::MatrixXd& maps);

/// Correlation coefficient of each two cases' maps over the vertices `overlap`, thesis Eq. (IV.5): symmetric,
/// ones on the diagonal. `cases` names the columns. Throws InputError for fewer than three vertices and for a
/// map that is constant there, which correlates with nothing.
[[nodiscard]] Eigen::MatrixXd mapCorrelation(const Eigen::MatrixXd& maps, const std::vector<Index>& overlap,
                                             const std::vector<std::string>& cases);

}  // namespace falciform
