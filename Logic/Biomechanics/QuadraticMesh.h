#pragma once
#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// The mesh with a node in the middle of every edge: T4 -> T10 in VTK's order (Logic/Core/TetrahedralMesh.h).
/// The corners keep their numbers; the new nodes follow, in the order in which the elements name their edges.
/// Edges stay straight. A quadratic mesh is returned as it is. Throws InputError for a damaged mesh.
[[nodiscard]] TetrahedralMesh quadraticMesh(const TetrahedralMesh& linear);

/// The corners of the elements alone: T10 -> T4, nodes that no corner uses dropped, the others in their
/// order. A linear mesh is returned as it is. Throws InputError for a damaged mesh.
[[nodiscard]] TetrahedralMesh linearMesh(const TetrahedralMesh& quadratic);

}  // namespace falciform
