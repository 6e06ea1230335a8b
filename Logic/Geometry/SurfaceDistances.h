#pragma once
#include "Logic/Core/Surface.h"

namespace falciform {

/// Distances of the places to the surface, mm, not signed: exact point to triangle. Throws InputError if the
/// surface has no triangles.
[[nodiscard]] VectorXd distancesTo(const Surface& surface, const Points& places);

}  // namespace falciform
