#pragma once

#include "Logic/Biomechanics/EliminationForest.h"
#include "Logic/Biomechanics/LargeMemory.h"
#include "Logic/Biomechanics/SupernodalStructure.h"
#include "Logic/Core/Progress.h"

namespace falciform {

/// A = L L' by the multifrontal method (Duff and Reid 1983; Liu 1992) on the supernodes that CHOLMOD finds:
/// subtrees of the elimination tree in parallel, the large fronts above them in parallel tiles. Same bits for
/// any number of threads, which threaded BLAS does not give.
class SparseCholesky {
 public:
  /// `order`: the elimination order, each variable once. Throws InputError if the matrix is not positive
  /// definite.
  SparseCholesky(const SparseLower& matrix, const std::vector<std::int64_t>& order,
                 const Progress& progress = {});

  /// A X = B in place of B, any number of columns.
  void solve(Eigen::MatrixXd& rightHandSides) const;

  [[nodiscard]] const SupernodalStructure& structure() const { return structure_; }
  /// The numbers of L, as `structure` says; each panel's rows above its diagonal hold nothing of use.
  [[nodiscard]] const double* values() const { return values_.get(); }
  [[nodiscard]] std::int64_t entries() const { return structure_.valuesBegin.back(); }
  [[nodiscard]] double operations() const { return operations_; }  ///< multiplications and additions made

 private:
  struct Fronts;
  SupernodalStructure structure_;
  ForestCut cut_;
  LargeArray<double> values_;
  double operations_ = 0;
};

}  // namespace falciform
