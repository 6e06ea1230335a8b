#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Surface.h"
#include "Testing/Benchmarks/Truths/TruthPlan.h"
#include "Testing/Verification/Calculix.h"

namespace falciform::bench {

/// A liver with a stiff tumour inside, held, packed and weighed as a plan says, ready for CalculiX.
struct TruthBody {
  verification::SharedProblem problem;  ///< regions 0 liver, 1 tumour; packs and gravity in full
  Vector3d tumourCentreMm = Vector3d::Zero();
  double heldShare = 0;  ///< of the surface's area
  std::vector<std::string> warnings;
};

/// `preop`: painted, LPS. The mesh has `edgeMm` and comes from meshLiver. Throws InputError where the liver
/// has no room for the tumour or no place for a pack.
[[nodiscard]] TruthBody truthBody(const Surface& preop, const TruthPlan& plan, double edgeMm);

/// Where the nodes go under `share` of packs and gravity.
struct TruthState {
  Points displacements;  ///< N x 3, mm
  double share = 1;      ///< of packs and gravity, that it is the solution for
  double minDetJ = 0;
  std::vector<std::string> refused;  ///< why larger shares were not taken
};

/// Solves by CalculiX in `folder` and takes the farthest state on the way to all of the load in which no
/// volume is pressed below a tenth of itself and the surface does not cut through itself. Throws
/// std::runtime_error, with the reasons, if none beyond a share of 0.3 is so.
[[nodiscard]] TruthState solveTruth(const TruthBody& body, const std::filesystem::path& calculix,
                                    const std::filesystem::path& folder);

}  // namespace falciform::bench
