#pragma once
#include <functional>

#include "Logic/Core/TetrahedralMesh.h"

namespace falciform::test {

/// A block from the origin to `sizeMm`, cut into `cells` boxes of six tetrahedra each (Kuhn), linear.
TetrahedralMesh blockMesh(const Vector3d& sizeMm, const Vector3i& cells);

/// The same with every inner corner moved at random by up to `share` of a cell: no symmetry left to hide a
/// mistake.
TetrahedralMesh shakenBlockMesh(const Vector3d& sizeMm, const Vector3i& cells, double share, unsigned seed);

}  // namespace falciform::test
