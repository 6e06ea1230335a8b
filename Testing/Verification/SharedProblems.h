#pragma once
#include "Testing/Verification/Calculix.h"

namespace falciform::verification {

/// The problems of the other files as CalculiX can be given them, with linear and with quadratic elements:
/// weight, shear and pressure; nodes fixed, sliding along slanted planes and pushed; two materials.
/// `refinement`: 1 and up, divides the elements' edges.
[[nodiscard]] std::vector<SharedProblem> sharedProblems(bool quadratic, int refinement);

}  // namespace falciform::verification
