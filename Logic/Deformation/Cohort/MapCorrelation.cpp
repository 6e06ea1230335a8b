#include "Logic/Deformation/Cohort/MapCorrelation.h"

#include <algorithm>

#include "Logic/Core/Errors.h"

namespace falciform {

std::vector<Index> commonCoverage(const Eigen::MatrixXd& maps) {
  std::vector<Index> rows;
  for (Index i = 0; i < maps.rows(); ++i)
    if (maps.row(i).allFinite()) rows.push_back(i);
  return rows;
}

Eigen::MatrixXd mapCorrelation(const Eigen::MatrixXd& maps, const std::vector<Index>& overlap,
                               const std::vector<std::string>& cases) {
  if (overlap.size() < 3)
    throw InputError("all cases together cover " + std::to_string(overlap.size()) + " of " +
                     std::to_string(maps.rows()) +
                     " vertices; three are the least: leave out the case that covers little");
  Eigen::MatrixXd unit = maps(overlap, Eigen::all);
  for (Index c = 0; c < unit.cols(); ++c) {
    const double largest = unit.col(c).cwiseAbs().maxCoeff();
    unit.col(c).array() -= unit.col(c).mean();
    const double length = unit.col(c).norm();
    // What is left of a constant by rounding is no pattern.
    if (length <= 1e-12 * largest * static_cast<double>(unit.rows()))
      throw InputError("the map of case '" + cases[static_cast<std::size_t>(c)] +
                       "' is the same all over the overlap, so it correlates with nothing; leave it out");
    unit.col(c) /= length;
  }
  Eigen::MatrixXd correlation = unit.transpose() * unit;
  for (Index i = 0; i < correlation.rows(); ++i) {
    correlation(i, i) = 1;
    for (Index j = 0; j < i; ++j)
      correlation(i, j) = correlation(j, i) = std::clamp(correlation(i, j), -1.0, 1.0);
  }
  return correlation;
}

}  // namespace falciform
