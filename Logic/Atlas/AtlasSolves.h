#pragma once
#include <functional>
#include <vector>

#include "Logic/Atlas/AtlasMembers.h"
#include "Logic/Core/Progress.h"

namespace falciform {

/// The linearly independent problems of an atlas: all that has to be solved. Members are sums of these.
struct AtlasSolves {
  struct Solve {
    int setup = 0;
    Eigen::RowVector4d load = Eigen::RowVector4d::Zero();  ///< push in mm, change of gravity in m/s2
  };
  std::vector<Solve> solves;     ///< by setup
  Eigen::MatrixXd combinations;  ///< M x K: members from solves
  /// Solves that are done together, so that their bits do not depend on who does them: numbers from `first`
  /// to `last`, all of one stiffness ratio.
  struct Batch {
    int first = 0, last = 0;
  };
  std::vector<Batch> batches;
};

[[nodiscard]] AtlasSolves planSolves(const AtlasMembers& members);

/// Displacements (N x 3, mm) of the solves of some batches, one after another; calls `done(batch, fields)`
/// for each. A stiffness ratio with a single setup is solved in double precision by elimination; several
/// setups share one factorisation (SupportSolver), to single precision. Throws InputError for supports that
/// do not hold the liver.
void solveBatches(const TetrahedralMesh& mesh, const AtlasDesign& design, const AtlasMembers& members,
                  const AtlasSolves& solves, const std::vector<int>& batches,
                  const std::function<void(int batch, std::vector<Points> fields)>& done,
                  const Progress& progress = {});

}  // namespace falciform
