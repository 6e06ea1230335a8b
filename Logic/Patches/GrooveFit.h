#pragma once
#include "Logic/Patches/FeatureTracing.h"

namespace falciform {

/// The line through the middle of where the groove is likely: its direction and place are those of the
/// likeliest part of the surface, weighted by probability and area, since on many livers there is no groove
/// to follow. From foot to top, 1 mm apart, on the surface; `logOdds` of the groove's scorer a vertex. Empty
/// if nowhere is likely.
[[nodiscard]] TracedLine fitGroove(const FeatureGround& ground, const VectorXd& logOdds);

/// Whether a line climbs rather than runs across the liver, as a groove does.
[[nodiscard]] bool climbs(const FeatureGround& ground, const Points& line);

/// Points of the valleys (crestLines, shallow ones too) of the front of the liver that climb, N x 3: of a
/// valley that goes on around the margin only the part in front.
[[nodiscard]] Points valleysInFront(const FeatureGround& ground);

}  // namespace falciform
