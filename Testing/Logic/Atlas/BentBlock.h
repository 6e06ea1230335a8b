#pragma once
#include "Logic/Core/TetrahedralMesh.h"

namespace falciform::test {

/// A block of 120 x 80 x 50 mm with uneven elements, and a bending of it in closed form.
struct BentBlock {
  TetrahedralMesh mesh;
  Points displacements;
};

/// Displacements of up to `largestMm` or so; in quadratic elements edges turn into curves.
[[nodiscard]] BentBlock bentBlock(bool quadratic, double largestMm = 12);

/// The closed form that the nodes follow: elements follow it up to their own shape functions.
[[nodiscard]] Vector3d bending(const Vector3d& place, double largestMm = 12);

/// `count` places drawn evenly from the block at rest, grown by `beyondMm` on all sides.
[[nodiscard]] Points placesAroundBlock(int count, double beyondMm, unsigned seed);

}  // namespace falciform::test
