#pragma once
#include "Logic/Core/Surface.h"
#include "Logic/Core/Volume.h"

namespace falciform::bench {

/// The map of Couinaud's segments of 3D-IRCADb's case `liver`, of the real data's folder `cohort/couinaud`.
/// Throws InputError where it is not there.
[[nodiscard]] LabelMap readSegments(int liver);

/// The liver's surface as a user would import it, painted as TruthPatches.h says.
[[nodiscard]] Surface importPainted(const LabelMap& segments, double edgeMm);

}  // namespace falciform::bench
