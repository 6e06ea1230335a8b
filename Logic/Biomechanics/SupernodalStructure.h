#pragma once
#include <cstdint>
#include <vector>

#include "Logic/Biomechanics/StiffnessMatrix.h"

namespace falciform {

/// The lower triangle of a symmetric matrix by compressed columns, diagonal included, rows ascending.
struct SparseLower {
  std::vector<std::int64_t> begin, rows;
  std::vector<double> values;

  [[nodiscard]] std::int64_t size() const { return static_cast<std::int64_t>(begin.size()) - 1; }
};

/// A nested-dissection order (METIS) of the nodes that are `kept` (empty: all), each once.
[[nodiscard]] std::vector<int> nestedDissection(const NodeGraph& graph, const std::vector<char>& kept = {});

/// Where the numbers of a Cholesky factor L stand. Supernode s is the columns super[s] to super[s + 1]; they
/// share the rows in rows[rowsBegin[s]...], their own first, and stand in values[valuesBegin[s]...] column by
/// column, as high as there are rows. Column j of L is variable order[j] of the matrix.
struct SupernodalStructure {
  std::vector<std::int64_t> super, rowsBegin, valuesBegin, rows, order;
  std::vector<int> parents;  ///< of each supernode, above it in number; -1 at roots

  [[nodiscard]] std::size_t supernodes() const { return parents.size(); }
  [[nodiscard]] std::int64_t width(std::size_t s) const { return super[s + 1] - super[s]; }
  [[nodiscard]] std::int64_t height(std::size_t s) const { return rowsBegin[s + 1] - rowsBegin[s]; }
};

/// By CHOLMOD's analysis (Chen, Davis, Hager, Rajamanickam 2008). `order`: the elimination order, each
/// variable once; variables may change places within it as far as the factor stays as sparse. Throws
/// InputError if this build is without CHOLMOD (CMake switch FALCIFORM_WITH_CHOLMOD).
[[nodiscard]] SupernodalStructure analyseSupernodes(const SparseLower& matrix,
                                                    const std::vector<std::int64_t>& order);

}  // namespace falciform
