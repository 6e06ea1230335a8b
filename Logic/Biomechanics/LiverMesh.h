#pragma once
#include <string>
#include <vector>

#include "Logic/Biomechanics/MeshSettings.h"
#include "Logic/Core/Progress.h"
#include "Logic/Core/Surface.h"
#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// The elements with one region number.
struct MeshRegion {
  int number = 0;  ///< 0: parenchyma; i: tumours[i - 1]
  Index elements = 0;
  double volumeMm3 = 0;
  double wantedMm3 = 0;    ///< volume that the tumour's surface encloses; 0 for the parenchyma
  bool conforming = true;  ///< the region's boundary is a surface of its own, made of faces
};

/// What came out, in figures.
struct MeshReport {
  Index nodes = 0, elements = 0, degreesOfFreedom = 0;
  double volumeMm3 = 0, inputVolumeMm3 = 0;
  double edgeLengthMm = 0;                           ///< the one used: a repair may choose a neighbouring one
  double minDihedralDeg = 0, medianDihedralDeg = 0;  ///< of the elements' smallest dihedral angles
  double minRadiusRatio = 0;     ///< 3 inscribed / circumscribed radius of the worst element; 1: regular
  double minScaledJacobian = 0;  ///< of the worst element's corners; 1: regular
  double meanDistanceMm = 0, maxDistanceMm = 0;  ///< from the mesh's boundary to the surface
  double maxUncoveredMm = 0;         ///< from the surface to the mesh's boundary: filled clefts, cut threads
  Index crossingPairs = 0;           ///< pairs of triangles that cut through each other before the repair
  std::vector<std::string> repairs;  ///< what was done about them, in words
  std::vector<MeshRegion> regions;   ///< by number
  std::vector<std::string> warnings;
};

struct LiverMesh {
  TetrahedralMesh mesh;  ///< region 0 parenchyma, i: tumours[i - 1]; in the surface's frame
  MeshReport report;
};

/// Fills a closed surface with tetrahedra: remeshed to the edge length, repaired where remeshing made it cut
/// through itself, filled by TetGen, with a node in the middle of every edge if quadratic. Tumours become
/// regions whose boundaries are element faces, or, where one reaches the surface or another tumour, the
/// elements whose centre is inside, with a warning. The same each time. Throws InputError for a surface that
/// is open, inside out, in several pieces, or cuts through itself beyond repair (which triangles, and where).
[[nodiscard]] LiverMesh meshLiver(const Surface& preop, const std::vector<Surface>& tumours,
                                  const MeshSettings& settings, const Progress& progress = {});

}  // namespace falciform
