#pragma once
#include "Logic/Geometry/ScannerSide.h"

namespace falciform {

/// Unit direction at right angles to `view` that shows the scan's longest extent from left to right, a
/// painted inferior ridge in the lower half.
[[nodiscard]] Vector3d uprightFor(const Surface& scan, const Vector3d& view);

}  // namespace falciform
