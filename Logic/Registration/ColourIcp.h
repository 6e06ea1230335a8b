#pragma once
#include "Logic/Registration/PatchIcp.h"
#include "Logic/Registration/PreparedPreop.h"

namespace falciform {

/// ICP whose closest points are nearest in place *and* colour (Johnson and Kang 1999): six coordinates, the
/// last three YIQ with lightness counting a tenth, scaled so that one standard deviation of the pre-op
/// surface's colours weighs as much as 0.3 of its RMS radius. It holds a textured scan where its shape
/// alone would slide. The fit uses places only. Throws InputError if a side has no colours; patches are not
/// looked at.
[[nodiscard]] PatchIcpResult registerColourIcp(const PreparedPreop& preop, const Surface& scan,
                                               const RegistrationSettings& settings,
                                               const Isometry3d& preopFromScanStart,
                                               const Progress& progress = {},
                                               const IterationObserver& observer = {});

}  // namespace falciform
