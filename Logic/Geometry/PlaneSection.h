#pragma once
#include "Logic/Core/Surface.h"

namespace falciform {

/// The outline of a surface on the plane where coordinate `axis` (0, 1 or 2) is `valueMm`: 2 S x 3, row 2 s
/// and 2 s + 1 the ends of segment s. A vertex on the plane counts as above it, so that the outline of a
/// closed surface is closed.
[[nodiscard]] Points planeSection(const Surface& surface, int axis, double valueMm);

}  // namespace falciform
