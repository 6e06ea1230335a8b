#pragma once
#include "Logic/Core/Surface.h"

namespace falciform {

/// Unit direction from the scan towards where its scanner stood, as far as the scan tells: the mean normal of
/// its triangles or points; for a cloud without normals the thinnest of its axes, on the side to which the
/// middle bulges over the rim.
[[nodiscard]] Vector3d facingOf(const Surface& scan);

/// Turns the triangles as a whole, and each normal, to the side of `towardsScanner`.
void faceTowards(Surface& scan, const Vector3d& towardsScanner);

/// Gives each point a unit normal: of the triangles around it, or of a plane through its 12 nearest, turned
/// towards the scanner.
void giveNormals(Surface& scan, const Vector3d& towardsScanner);

}  // namespace falciform
