#pragma once
#include <vector>

#include "Logic/Core/TetrahedralMesh.h"

namespace falciform::distributed {

/// Which rank owns which nodes: rank r those at places begin[r] to begin[r + 1] of `nodes`.
struct NodeShares {
  std::vector<int> nodes;    ///< every node once; neighbours in space are near each other
  std::vector<int> placeOf;  ///< of each node in `nodes`
  std::vector<int> begin;    ///< ranks + 1

  [[nodiscard]] int ranks() const { return static_cast<int>(begin.size()) - 1; }
};

/// Cuts the nodes' box across its longest side, again and again: shares of equal size (to one node) with
/// small borders. The same on every rank. Throws InputError if there are fewer nodes than ranks.
[[nodiscard]] NodeShares shareNodes(const Points& nodes, int ranks);

/// The elements that touch a rank's nodes, as a mesh of their own: what it takes to assemble the rows of K,
/// and the loads, of those nodes wholly.
struct OwnElements {
  TetrahedralMesh mesh;
  std::vector<int> nodes;  ///< of the mesh's nodes in the whole, ascending

  /// The number here of a node of the whole that is here.
  [[nodiscard]] int at(int node) const;
};
[[nodiscard]] OwnElements ownElements(const TetrahedralMesh& whole, const NodeShares& shares, int rank);

}  // namespace falciform::distributed
