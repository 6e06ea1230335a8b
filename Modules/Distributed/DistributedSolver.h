#pragma once
#include <memory>

#include "Logic/Biomechanics/Supports.h"
#include "Modules/Distributed/NodeShares.h"
#include "Modules/Distributed/Ranks.h"

namespace falciform::distributed {

/// When the conjugate gradients stop: at a residual of `relativeTolerance` times the load's.
struct IterationPlan {
  double relativeTolerance = 1e-10;
  int maxIterations = 2000;
};

/// K with one set of supports, spread over ranks: what ConstrainedStiffness is where a factor no longer fits
/// into one machine. Each rank assembles and keeps the rows of its own nodes, in their normal-tangential
/// frames; solved by conjugate gradients with smoothed-aggregation multigrid (PETSc's GAMG), whose coarse
/// spaces hold the six rigid motions. All members are called on all ranks together. Springs are not for this
/// one.
class DistributedSolver {
 public:
  /// The whole mesh and all constraints, ascending by node, on every rank. Throws InputError for a damaged
  /// mesh or material.
  DistributedSolver(const Ranks& ranks, const TetrahedralMesh& mesh, const NodeShares& shares,
                    const std::vector<Material>& materials, const std::vector<NodeConstraint>& constraints,
                    const IterationPlan& plan = {});

  /// Displacements in mm (N x 3) on the first rank, nothing on others, under nodal forces in N (N x 3, all of
  /// them on every rank); the constrained directions at their values times `scale`. Throws InputError if the
  /// iteration does not get there.
  [[nodiscard]] Points solve(const Points& forces, double scale = 1);

  [[nodiscard]] int iterations() const;         ///< of the last solve
  [[nodiscard]] double matrixBytes() const;     ///< of K, all ranks
  [[nodiscard]] double gridComplexity() const;  ///< entries of all grids' matrices by those of K

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace falciform::distributed
