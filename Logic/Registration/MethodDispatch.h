#pragma once
#include <optional>

#include "Logic/Core/Results.h"
#include "Logic/Registration/PatchIcp.h"
#include "Logic/Registration/PreparedPreop.h"

namespace falciform {

/// What a method beside the loop of chapter III finds.
struct OtherMethodResult {
  PatchIcpResult run;
  std::optional<RegistrationWarp> warp;  ///< of the non-rigid ones
};

/// Runs the method of the settings, one for which isOtherMethod holds, from the pose given. Throws InputError
/// for what the method needs and does not find.
[[nodiscard]] OtherMethodResult runOtherMethod(const PreparedPreop& preop, const Surface& scan,
                                               const RegistrationSettings& settings,
                                               const Isometry3d& preopFromScanStart, const Progress& progress,
                                               const IterationObserver& observer);

}  // namespace falciform
