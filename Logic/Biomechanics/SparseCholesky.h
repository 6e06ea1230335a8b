#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "Logic/Biomechanics/StiffnessMatrix.h"
#include "Logic/Core/Progress.h"

namespace falciform {

/// The lower triangle of a symmetric matrix by compressed columns, diagonal included, rows ascending.
struct SparseLower {
  std::vector<std::int64_t> begin, rows;
  std::vector<double> values;

  [[nodiscard]] std::int64_t size() const { return static_cast<std::int64_t>(begin.size()) - 1; }
};

/// A nested-dissection order (METIS) of the nodes that are `kept` (empty: all), each once.
[[nodiscard]] std::vector<int> nestedDissection(const NodeGraph& graph, const std::vector<char>& kept = {});

/// A factor by supernodes: columns super[s] to super[s + 1] of L share the rows in rows[rowsBegin[s]...],
/// their own first, and stand in values[valuesBegin[s]...] column by column, as high as there are rows.
/// Column j of L is variable order[j] of the matrix.
struct SupernodalView {
  std::span<const std::int64_t> super, rowsBegin, valuesBegin, rows, order;
  const double* values = nullptr;
};

/// A = L L' by CHOLMOD's supernodal method (Chen, Davis, Hager, Rajamanickam 2008), on all threads.
class SparseCholesky {
 public:
  /// `order`: the elimination order, each variable once; its end stays at the end. Throws InputError if the
  /// matrix is not positive definite, or this build is without CHOLMOD (CMake switch FALCIFORM_WITH_CHOLMOD).
  SparseCholesky(const SparseLower& matrix, const std::vector<std::int64_t>& order,
                 const Progress& progress = {});

  /// A X = B in place of B, any number of columns.
  void solve(Eigen::MatrixXd& rightHandSides) const;
  /// Numbers in L, and what they occupy.
  [[nodiscard]] double entries() const;
  [[nodiscard]] SupernodalView supernodes() const;

 private:
  struct Factor;
  std::shared_ptr<Factor> factor_;
};

}  // namespace falciform
