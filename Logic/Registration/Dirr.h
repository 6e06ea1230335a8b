#pragma once
#include "Logic/Registration/PatchIcp.h"
#include "Logic/Registration/PreparedPreop.h"

namespace falciform {

/// Deformation identifying rigid registration (Cash et al. 2005, 2007): among rigid poses near the start, the
/// one under which the largest share of the scan lies on the pre-op surface, whatever the rest does, so that
/// the part that did not deform decides and the part that did stands out. Powell's method maximises the mean
/// of exp(-d^2 / 2 s^2) over a spread sample of the scan; s falls from the start's own residuals to 2 mm.
/// Patches are not looked at; one record a sweep. Local: the start must be near.
[[nodiscard]] PatchIcpResult registerDirr(const PreparedPreop& preop, const Surface& scan,
                                          const RegistrationSettings& settings,
                                          const Isometry3d& preopFromScanStart, const Progress& progress = {},
                                          const IterationObserver& observer = {});

}  // namespace falciform
