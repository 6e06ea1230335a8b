#pragma once
#include "Logic/Core/Results.h"
#include "Logic/Registration/PreparedPreop.h"
#include "Logic/Registration/RegistrationSettings.h"

namespace falciform {

/// The pose in `pose` with all its figures, as registerSurfaces would give them; nothing moves. For a pose
/// that was stopped at, chosen among the basins, or set by hand. Kept as they are: history, basins, stop
/// reason, what is known of target error, and the warnings, to which those of the figures are added. Throws
/// InputError for a scan or settings that registerSurfaces would refuse.
[[nodiscard]] RegistrationResult evaluatePose(RegistrationResult pose, const PreparedPreop& preop,
                                              const Surface& scan, const RegistrationSettings& settings,
                                              const Isometry3d& scanFromPreopStart = Isometry3d::Identity());

}  // namespace falciform
