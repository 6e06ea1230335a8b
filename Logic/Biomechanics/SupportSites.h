#pragma once
#include <string>
#include <vector>

#include "Logic/Biomechanics/BoundaryFaces.h"
#include "Logic/Biomechanics/GroovePlane.h"

namespace falciform {

/// The outer faces of a liver's mesh as the places where supports are looked for. Regions are by the
/// direction that the faces' neighbourhood looks in (mean normal within 12 mm), in patient LPS; ascending
/// face numbers; no face is in two of them.
struct SupportSites {
  GroovePlane groove;
  std::vector<int> venaCava;        ///< around the retrohepatic vena cava: fixed
  std::vector<int> posteriorBed;    ///< right lobe's back, on which the liver lies: sliding
  std::vector<int> leftUnderside;   ///< visceral faces left of the groove's plane: packed
  std::vector<int> rightUnderside;  ///< and right of it
  Points centres;                   ///< F x 3: of all boundary faces, mm
  VectorXd areasMm2;                ///< F
  BoundarySurface boundary;         ///< triangles in the order of the faces
  std::vector<std::string> warnings;
};

/// Finds the regions on a mesh of `preop` (LPS; patch 1 places the plane between the lobes, without it the
/// middle of the liver's box, with a warning). Throws InputError if a region turns out empty, naming it:
/// then the surface is no liver in LPS.
[[nodiscard]] SupportSites findSupportSites(const Surface& preop, const TetrahedralMesh& mesh,
                                            const BoundaryFaces& faces);

/// Faces of the undersides, or of `within`, within `radiusMm` of the one nearest to `centre`, along the
/// surface, that look the same way as the place as a whole (within 40 degrees); never empty. Throws
/// InputError for a radius that is not above 0.
[[nodiscard]] std::vector<int> packingSite(const SupportSites& sites, const Vector3d& centre,
                                           double radiusMm);
[[nodiscard]] std::vector<int> packingSite(const SupportSites& sites, const Vector3d& centre, double radiusMm,
                                           const std::vector<int>& within);

/// `count` places, each the centre of an underside face, spread evenly over both undersides: farthest points,
/// then moved to the middle of what is nearest to each. The same each time. Throws InputError for a count
/// below 1 or above the number of faces there.
[[nodiscard]] std::vector<Vector3d> packingSites(const SupportSites& sites, int count);

/// The centre of a region by area, mm.
[[nodiscard]] Vector3d centreOf(const SupportSites& sites, const std::vector<int>& faces);

}  // namespace falciform
