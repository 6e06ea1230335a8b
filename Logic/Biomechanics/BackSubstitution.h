#pragma once
#include <vector>

#include "Logic/Biomechanics/SparseCholesky.h"

namespace falciform {

/// From the values of a factor's last variables to all the others, in equilibrium under no load of their own:
/// the second half of a solve, x_i = -L_ii^-T L_ci' x_c, in single precision. One pass over half the memory
/// of the factor, on all threads; same bits for any number of them.
class BackSubstitution {
 public:
  /// `last`: how many variables at the end of the order are given. The factor may be dropped afterwards.
  BackSubstitution(const SparseCholesky& factor, std::int64_t last);

  /// `values`: all variables by columns in the factor's order, those at the end given, the others
  /// overwritten.
  void solve(Eigen::MatrixXf& values) const;

 private:
  struct Panel {
    std::int64_t firstColumn, width, height, values, rows;  ///< places in values_ and rows_
  };
  void solvePanel(const Panel& panel, Eigen::MatrixXf& values, bool parallel,
                  std::vector<float>& space) const;

  LargeArray<float> values_;
  std::vector<std::int64_t> rows_;
  std::vector<Panel> panels_;
  ForestCut cut_;
};

}  // namespace falciform
