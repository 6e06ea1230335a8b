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

/// The strongest valley line (crestLines) of the front of the liver, between its lobes, that climbs: for
/// livers unlike those that people marked, whose groove can be seen. From foot to top; empty if there is
/// none.
[[nodiscard]] TracedLine valleyGroove(const FeatureGround& ground, const VectorXd& logOdds);

}  // namespace falciform
