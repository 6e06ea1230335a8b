#pragma once
#include "Logic/Core/Surface.h"

namespace falciform {

struct TetrahedralMesh {
  Points points;                                                    ///< mm; the surface's points come first, in order
  Eigen::Matrix<int, Eigen::Dynamic, 4, Eigen::RowMajor> tetrahedra;  ///< positive volume
};

/// Fills a closed surface with quality tetrahedra by TetGen (Si 2015), none larger than `maxVolumeMm3` (0: no bound),
/// boundary kept as it is. Throws InputError for an open or self-intersecting surface, and when this build is without
/// TetGen (CMake switch FALCIFORM_WITH_TETGEN; Docs/Licences.md).
[[nodiscard]] TetrahedralMesh tetrahedralise(const Surface& surface, double maxVolumeMm3 = 0);

}  // namespace falciform
