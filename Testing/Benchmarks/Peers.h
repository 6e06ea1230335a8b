#pragma once
#include "Logic/Core/Surface.h"

namespace falciform::bench {

/// Rigid registration of the scan to the pre-op surface by a peer, from the pose as given, run to its own
/// convergence with settings as a careful user would choose. Returns preopFromScan.
[[nodiscard]] Isometry3d vtkIcp(const Surface& preop, const Surface& scan);
[[nodiscard]] Isometry3d pclIcp(const Surface& preop, const Surface& scan);

}  // namespace falciform::bench
