#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "Testing/Verification/HeldBody.h"

namespace falciform::verification {

/// A problem put to two programs: loads are said in CalculiX's own words where it has any, so that its
/// integration of weight and pressure is compared as well.
struct SharedProblem {
  std::string name;
  HeldBody body;                              ///< with all loads as nodal forces
  Vector3d gravityMPerS2 = Vector3d::Zero();  ///< *DLOAD GRAV
  std::vector<int> pressedFaces{};            ///< *DLOAD P, of boundary faces
  double pressureMPa = 0;
  bool asNodalForces = false;  ///< *CLOAD instead of the above
  /// Neo-Hookean of the same moduli, W = mu/2 (I1 J^(-2/3) - 3) + kappa/2 (J - 1)^2, and large displacement.
  bool neoHookean = false;
};

/// CalculiX's executable `ccx` (Debian: calculix-ccx) on the path.
[[nodiscard]] std::optional<std::filesystem::path> findCalculix();

/// What CalculiX is to print: the state under all of the load, or every state on its way there, which it then
/// takes by a fifth at most.
enum class Printed { LastState, EveryState };

/// The problem as an input file: C3D4 or C3D10, *BOUNDARY for nodes held wholly, *EQUATION for those held
/// along directions of their own.
[[nodiscard]] std::string calculixInput(const SharedProblem& problem, Printed printed = Printed::LastState);

/// Runs CalculiX in `folder`: displacements in mm, N x 3, to the seven digits that it prints. Throws
/// std::runtime_error with the end of its log if it gives none.
[[nodiscard]] Points solveWithCalculix(const SharedProblem& problem, const std::filesystem::path& calculix,
                                       const std::filesystem::path& folder);

/// The solution under a share of all loads and of all given displacements.
struct LoadState {
  double share = 0;
  Points displacements;
};
/// Every state that CalculiX finds between none and all of the load, ascending, though it may not get to the
/// end: loads and given displacements grow together, so that each is what the problem with less of both has
/// for its solution. For problems in large displacement. Throws std::runtime_error with the end of its log if
/// there is none.
[[nodiscard]] std::vector<LoadState> loadPathWithCalculix(const SharedProblem& problem,
                                                          const std::filesystem::path& calculix,
                                                          const std::filesystem::path& folder);

}  // namespace falciform::verification
