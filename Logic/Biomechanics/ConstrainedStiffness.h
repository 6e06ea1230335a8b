#pragma once
#include "Logic/Biomechanics/ReducedStiffness.h"
#include "Logic/Biomechanics/SparseCholesky.h"

namespace falciform {

/// K with one set of supports, factorised once, for any number of loads: the direct way, by elimination.
class ConstrainedStiffness {
 public:
  /// Constraints ascending by node; springs already in `stiffness`. Throws InputError if the result is not
  /// positive definite.
  ConstrainedStiffness(StiffnessMatrix stiffness, std::vector<NodeConstraint> constraints,
                       const Progress& progress = {});

  /// Displacements in mm (N x 3) under nodal forces in N (N x 3), the constrained directions at their values.
  [[nodiscard]] Points solve(const Points& forces) const;
  /// The same for several loads at once; load k takes the constraints' values times `scales[k]`.
  [[nodiscard]] std::vector<Points> solve(const std::vector<Points>& forces,
                                          const std::vector<double>& scales) const;
  /// Forces in N that the supports bear (N x 3) in that state: K u - f at their nodes, zero elsewhere.
  [[nodiscard]] Points reactions(const Points& displacements, const Points& forces) const;

  [[nodiscard]] const StiffnessMatrix& stiffness() const { return stiffness_; }
  [[nodiscard]] Index freeDirections() const { return static_cast<Index>(reduced_.directions().size()); }
  [[nodiscard]] const SparseCholesky& factor() const { return factor_; }

 private:
  StiffnessMatrix stiffness_;
  ReducedStiffness reduced_;
  SparseCholesky factor_;
};

}  // namespace falciform
