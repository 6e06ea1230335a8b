#pragma once
#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// The shape of one tetrahedron of corners.
struct ElementShape {
  double minDihedralDeg = 0;  ///< smallest angle between two faces; 70.5 in a regular one
  double radiusRatio = 0;     ///< 3 inscribed / circumscribed radius; 1 in a regular one, 0 if flat
  double scaledJacobian = 0;  ///< sqrt(2) times the least corner's triple product over its edges' lengths; 1
                              ///< in a regular one
};
[[nodiscard]] ElementShape shapeOf(const TetrahedralMesh& mesh, Index element);

/// The shapes of all elements in figures.
struct MeshQuality {
  double minDihedralDeg = 0, medianDihedralDeg = 0;  ///< of the elements' smallest dihedral angles
  double minRadiusRatio = 0, minScaledJacobian = 0;
  double volumeMm3 = 0;
  double meanEdgeMm = 0;
};
[[nodiscard]] MeshQuality meshQuality(const TetrahedralMesh& mesh);

}  // namespace falciform
