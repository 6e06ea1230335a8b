#pragma once
#include <vector>

#include "Logic/Core/Surface.h"
#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// Fills a closed surface with quality tetrahedra by TetGen (Si 2015), boundary kept as it is (the surface's
/// points come first, in order), refined until
/// they are about `maxVolumeMm3` or less (0: no bound; on the boundary its triangles decide). The result is
/// the same each time. Throws InputError for an open, inside-out or self-intersecting surface, and when this
/// build is without TetGen (CMake switch FALCIFORM_WITH_TETGEN; Docs/Licences.md).
[[nodiscard]] TetrahedralMesh tetrahedralise(const Surface& surface, double maxVolumeMm3 = 0);

/// How a surface is filled, and with what inside.
struct TetrahedraPlan {
  double maxVolumeMm3 = 0;         ///< as above
  double radiusEdgeRatio = 1.414;  ///< largest circumscribed radius over shortest edge aimed at
  double minDihedralDeg = 10;      ///< aimed at
  /// Closed surfaces inside that do not touch it or each other: their triangles become faces of tetrahedra.
  std::vector<Surface> inner = {};
  std::vector<double> innerMaxVolumeMm3 = {};  ///< of the tetrahedra just inside each; 0 or empty: as outside
  Points extra = {};                           ///< places inside that become nodes
};

/// The same with inner surfaces. Nodes: the surface's points, those of the inner surfaces in their order, the
/// extra ones, then TetGen's own.
[[nodiscard]] TetrahedralMesh tetrahedralise(const Surface& surface, const TetrahedraPlan& plan);

}  // namespace falciform
