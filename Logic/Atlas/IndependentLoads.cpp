#include "Logic/Atlas/IndependentLoads.h"

#include <Eigen/QR>
#include <algorithm>
#include <vector>

namespace falciform {
namespace {

constexpr double kDependent = 1e-12;  // of the largest pivot, after columns are brought to one size

}  // namespace

IndependentLoads independentLoads(const Eigen::MatrixXd& loads) {
  std::vector<Eigen::Index> used;
  for (Eigen::Index c = 0; c < loads.cols(); ++c)
    if (loads.rows() > 0 && loads.col(c).cwiseAbs().maxCoeff() > 0) used.push_back(c);
  const auto columns = static_cast<Eigen::Index>(used.size());
  IndependentLoads result{.basis = Eigen::MatrixXd::Zero(0, loads.cols()),
                          .coefficients = Eigen::MatrixXd::Zero(loads.rows(), 0)};
  if (columns == 0) return result;
  // mm and m/s2 stand side by side: without this a small unit would hide a direction.
  Eigen::MatrixXd scaled(columns, loads.rows());
  for (Eigen::Index c = 0; c < columns; ++c)
    scaled.row(c) = loads.col(used[static_cast<std::size_t>(c)]).transpose() /
                    loads.col(used[static_cast<std::size_t>(c)]).cwiseAbs().maxCoeff();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> pivoted(scaled);
  pivoted.setThreshold(kDependent);
  const Eigen::Index rank = pivoted.rank();
  result.basis = Eigen::MatrixXd::Zero(rank, loads.cols());
  result.coefficients = Eigen::MatrixXd::Zero(loads.rows(), rank);
  if (rank == columns && loads.rows() > rank) {
    for (Eigen::Index k = 0; k < rank; ++k) {
      result.basis(k, used[static_cast<std::size_t>(k)]) = 1;
      result.coefficients.col(k) = loads.col(used[static_cast<std::size_t>(k)]);
    }
    return result;
  }
  std::vector<Eigen::Index> chosen(pivoted.colsPermutation().indices().data(),
                                   pivoted.colsPermutation().indices().data() + rank);
  std::sort(chosen.begin(), chosen.end());
  Eigen::MatrixXd base(columns, rank);
  for (Eigen::Index k = 0; k < rank; ++k) {
    result.basis.row(k) = loads.row(chosen[static_cast<std::size_t>(k)]);
    base.col(k) = scaled.col(chosen[static_cast<std::size_t>(k)]);
  }
  result.coefficients = base.colPivHouseholderQr().solve(scaled).transpose();
  for (Eigen::Index k = 0; k < rank; ++k) {
    // The chosen ones are themselves, without rounding.
    result.coefficients.row(chosen[static_cast<std::size_t>(k)]).setZero();
    result.coefficients(chosen[static_cast<std::size_t>(k)], k) = 1;
  }
  return result;
}

}  // namespace falciform
