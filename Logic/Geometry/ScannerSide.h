#pragma once
#include "Logic/Core/Surface.h"

namespace falciform {

/// Unit direction from the scan towards where its scanner stood, as far as the scan tells: the mean normal of
/// its triangles; for a cloud the direction that shows most of it, on the side to which the middle bulges
/// over the rim.
[[nodiscard]] Vector3d seenFrom(const Surface& scan);

}  // namespace falciform
