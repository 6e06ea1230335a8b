#pragma once
#include "Logic/Core/Progress.h"
#include "Logic/Core/Results.h"
#include "Logic/Registration/PreparedPreop.h"
#include "Logic/Registration/RegistrationSettings.h"

namespace falciform {

/// Finds where the scan lies on the pre-operative surface (thesis ch. III). Source is the scan, target the
/// pre-op surface's points; both keep their frames. `scanFromPreopStart`: the one start for
/// RegistrationStart::Given, and what motion is reported against. Stop (a Cancelled progress) throws. Throws
/// InputError: fewer than 3 points on a side, a patch that is asked for and missing on a side.
[[nodiscard]] RegistrationResult registerSurfaces(
    const PreparedPreop& preop, const Surface& scan, const RegistrationSettings& settings,
    const Isometry3d& scanFromPreopStart = Isometry3d::Identity(), const Progress& progress = {},
    const IterationObserver& observer = {});
/// The same for a surface that is used once.
[[nodiscard]] RegistrationResult registerSurfaces(
    const Surface& preop, const Surface& scan, const RegistrationSettings& settings,
    const Isometry3d& scanFromPreopStart = Isometry3d::Identity(), const Progress& progress = {},
    const IterationObserver& observer = {});

}  // namespace falciform
