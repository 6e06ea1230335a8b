#pragma once
#include <limits>
#include <optional>
#include <string>

#include "Logic/Core/Progress.h"
#include "Logic/Registration/PreparedPreop.h"

namespace falciform {

/// Points inside the organ whose true place in the scan is known: N x 3 each, rows correspond, N may be 0.
struct TrialTargets {
  Points preop;  ///< LPS mm
  Points scan;   ///< scan mm
};

/// Where the scan belongs: the pose that trials perturb and are measured against.
struct GoldStandard {
  Isometry3d scanFromPreop = Isometry3d::Identity();
  std::string source;  ///< in words: what it rests on
  double rmsMm = 0;    ///< of all scan points to the nearest pre-op point: real distances
  double targetErrorMm = std::numeric_limits<double>::quiet_NaN();  ///< mean over the targets; NaN: none
};

/// `given` (pre-op mm to scan mm) if there is one; else the best rigid fit of the targets to their true
/// places, if they are three or more and not on one line; else the default registration from the patches that
/// both surfaces have. Throws InputError if there is none of these.
[[nodiscard]] GoldStandard goldStandard(const PreparedPreop& preop, const Surface& scan,
                                        const TrialTargets& targets, const std::optional<Isometry3d>& given,
                                        const Progress& progress = {});

}  // namespace falciform
