#pragma once
#include <string>

#include "Logic/Core/Landmarks.h"
#include "Logic/Core/Types.h"
#include "Logic/Registration/RegistrationSettings.h"
#include "Modules/CommandLine/CommandRun.h"

namespace falciform::commandline {

/// Where a registration begins, and why, in words.
struct StartPose {
  Isometry3d scanFromPreop = Isometry3d::Identity();
  std::string words = {};  ///< "the patches of both surfaces", "landmarks, FRE 2.1 mm", ...
  std::string reference = "the pose as stored";  ///< what rotation and translation are told against
};

/// `init` is "identity", "landmarks", a transform file that maps pre-op mm to scan mm, or empty. A given pose
/// makes `settings.start` Given; without one, ICP starts from the identity (it knows no patches) and the
/// others as the settings say. Throws InputError for "landmarks" without both lists.
[[nodiscard]] StartPose resolveStart(const std::string& init, RegistrationSettings& settings,
                                     const Landmarks& preopLandmarks, const Landmarks& scanLandmarks,
                                     CommandRun& run);

}  // namespace falciform::commandline
