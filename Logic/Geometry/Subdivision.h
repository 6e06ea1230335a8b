#pragma once
#include "Logic/Core/Surface.h"

namespace falciform {

/// Every triangle cut into four at the middles of its edges; the shape stays as it is. The old points come
/// first. A new point takes the patch label that both ends of its edge share, else none; other point data is
/// dropped.
[[nodiscard]] Surface subdivided(const Surface& surface);

/// Subdivided until the mean edge is at most `edgeLengthMm`; the surface itself if it is already, or has no
/// triangles. Throws InputError for a length that is not above 0, or would make more than 20 million
/// triangles.
[[nodiscard]] Surface subdividedTo(const Surface& surface, double edgeLengthMm);

}  // namespace falciform
