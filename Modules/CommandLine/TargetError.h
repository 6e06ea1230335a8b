#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "Logic/Core/LandmarkPairs.h"
#include "Logic/Core/Results.h"
#include "Logic/Core/Types.h"

namespace falciform::commandline {

/// How far targets land from where they truly are: the error that matters, known only where there is truth.
struct TargetError {
  std::vector<std::string> names;
  VectorXd errorsMm;
  VectorXd expectedMm;  ///< as the registration expected them; empty where the method expects nothing
  double meanMm = 0, rmsMm = 0, maxMm = 0;
  double startMeanMm = 0;         ///< before the registration
  double optimalRigidMeanMm = 0;  ///< of the rigid motion fitted to the targets themselves: the rest is
                                  ///< deformation; NaN below 3 targets
};

/// Targets (pre-op mm) through the registration (its warp, where it has one) against `truth` (scan mm),
/// paired as pairTargets does.
[[nodiscard]] TargetError measureTargetError(const Landmarks& targets, const Landmarks& truth,
                                             const RegistrationResult& registration,
                                             const Isometry3d& scanFromPreopStart);

[[nodiscard]] nlohmann::json toJson(const TargetError& error);

}  // namespace falciform::commandline
