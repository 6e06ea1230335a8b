#pragma once
#include "Logic/Core/Surface.h"
#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// Fills a closed surface with quality tetrahedra by TetGen (Si 2015), boundary kept as it is (the surface's
/// points come first, in order), refined until
/// they are about `maxVolumeMm3` or less (0: no bound; on the boundary its triangles decide). The result is
/// the same each time. Throws InputError for an open, inside-out or self-intersecting surface, and when this
/// build is without TetGen (CMake switch FALCIFORM_WITH_TETGEN; Docs/Licences.md).
[[nodiscard]] TetrahedralMesh tetrahedralise(const Surface& surface, double maxVolumeMm3 = 0);

}  // namespace falciform
