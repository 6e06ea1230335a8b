#pragma once
#include "Logic/Core/Surface.h"

namespace falciform {

/// Turns the triangles as a whole, and each normal, to the side of `towardsScanner`.
void faceTowards(Surface& scan, const Vector3d& towardsScanner);

/// Gives each point a unit normal: of the triangles around it, or of a plane through its 12 nearest, turned
/// towards the scanner.
void giveNormals(Surface& scan, const Vector3d& towardsScanner);

}  // namespace falciform
