#pragma once
#include "Logic/Core/Surface.h"
#include "Testing/Benchmarks/Truths/CohortPlan.h"
#include "Testing/Verification/HeldBody.h"

namespace falciform::bench {

/// A liver held, its front moved and its weight turned as a plan says.
struct CohortBody {
  verification::HeldBody body;  ///< forces: the change of weight
  double heldShare = 0;         ///< of the surface's area, fixed
};

/// `preop`: painted, LPS.
[[nodiscard]] CohortBody cohortBody(const Surface& preop, const CohortPlan& plan, double edgeMm);

/// Where the nodes go under `share` of pushes and gravity.
struct CohortState {
  Points displacements;  ///< N x 3, mm
  double share = 1, minDetJ = 0;
};

/// Logic/Biomechanics' own linear solution on quadratic elements, its turns made true. Of 1, 0.8, 0.64, ...
/// of the loads the largest in which no volume is pressed below a tenth of itself. Throws InputError where
/// that is less than a quarter.
[[nodiscard]] CohortState solveCohort(const CohortBody& body);

}  // namespace falciform::bench
