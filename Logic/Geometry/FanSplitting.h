#pragma once
#include "Logic/Core/Surface.h"

namespace falciform {

/// The surface with each point that several fans of triangles share given to each of them as a copy of its
/// own. Point data is dropped; no edge may have three triangles.
[[nodiscard]] Surface withFansApart(const Surface& surface);

}  // namespace falciform
