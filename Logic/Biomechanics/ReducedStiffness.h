#pragma once
#include <utility>

#include "Logic/Biomechanics/SupernodalStructure.h"
#include "Logic/Biomechanics/Supports.h"

namespace falciform {

/// K in the nodes' normal-tangential frames without the constrained directions, K' = T K T', Eq. (V.12) with
/// the errata: what is left to solve for.
class ReducedStiffness {
 public:
  /// `constraints` ascending by node; one of count 0 only turns its node's frame. Throws InputError if
  /// nothing is left free.
  ReducedStiffness(const StiffnessMatrix& stiffness, std::vector<NodeConstraint> constraints);

  [[nodiscard]] const SparseLower& matrix() const { return matrix_; }
  /// 3 * node + row of the node's frame, for each variable of the matrix, ascending.
  [[nodiscard]] const std::vector<std::int64_t>& directions() const { return directions_; }
  /// The node's frame: rows are directions; null where it is that of the axes.
  [[nodiscard]] const Matrix3d* frameOf(std::int64_t node) const;
  /// The variables in a nested-dissection order of their nodes, but for those marked in `last` (empty: none),
  /// which follow in ascending order.
  [[nodiscard]] std::vector<std::int64_t> order(const NodeGraph& graph,
                                                const std::vector<char>& last = {}) const;
  /// Nodal vectors (N x 3) as variables, and variables as nodal vectors, constrained directions 0.
  void gather(const Points& nodal, Eigen::Ref<VectorXd> variables) const;
  [[nodiscard]] Points scatter(const Eigen::Ref<const VectorXd>& variables) const;
  /// The constraints' values as a nodal field, zero elsewhere.
  [[nodiscard]] Points prescribed() const;
  [[nodiscard]] const std::vector<NodeConstraint>& constraints() const { return constraints_; }

 private:
  void assemble(const StiffnessMatrix& stiffness);

  Index nodes_;
  std::vector<NodeConstraint> constraints_;
  std::vector<int> constraintOf_;  ///< of each node, or -1
  std::vector<std::int64_t> directions_;
  SparseLower matrix_;
};

/// The matrix with zeros stored at the given (row, column) places, row > column, that it lacks.
[[nodiscard]] SparseLower withPlaces(const SparseLower& matrix,
                                     std::vector<std::pair<std::int64_t, std::int64_t>> places);

}  // namespace falciform
