#pragma once
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Results.h"
#include "Logic/Registration/LabelledSource.h"
#include "Logic/Registration/LabelledTarget.h"
#include "Logic/Registration/RegistrationSettings.h"

namespace falciform {

struct PatchIcpResult {
  Isometry3d preopFromScan = Isometry3d::Identity();
  std::vector<IterationRecord> history;
  bool converged = false;
  std::string stopReason;
};

/// w_PBR(i) of Eq. (III.3), iteration i >= 1: w_max at i = 1, falling to w_base. 1 for Icp, w_max for Wgf.
[[nodiscard]] double patchWeight(const RegistrationSettings& settings, int iteration);

/// The loop of chapter III: closest points of Eq. (III.1), weighted fit of Eq. (III.2), weight of Eq.
/// (III.3), from one start. `firstIteration` > 1 continues a run whose weight has already relaxed so far.
/// Every method of RegistrationMethod is this loop with other values.
[[nodiscard]] PatchIcpResult runPatchIcp(const LabelledTarget& target, const LabelledSource& source,
                                         const RegistrationSettings& settings,
                                         const Isometry3d& preopFromScanStart, int firstIteration = 1,
                                         const Progress& progress = {},
                                         const IterationObserver& observer = {});

}  // namespace falciform
