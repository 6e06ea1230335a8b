#pragma once
#include "Logic/Atlas/Atlas.h"
#include "Logic/Atlas/UpdateMethods.h"

namespace falciform::test {

/// A block bent into a lopsided bean of quadratic tetrahedra, domed above and flat below, so that what is
/// seen of it from above fits nowhere else.
[[nodiscard]] TetrahedralMesh beanMesh();

/// Its surface, with two bands painted as patches 1 and 2.
[[nodiscard]] const Surface& beanSurface();

/// Six places of its underside pressed by five amounts each: 30 members of up to 7.5 mm RMS. Made once.
[[nodiscard]] const Atlas& beanAtlas();

/// A deformation within the atlas's span, and what a scanner above sees of it.
struct BeanTruth {
  Isometry3d scanFromPreop;
  Points displacements;  ///< of the mesh's nodes, mm
  Points before, after;  ///< places inside, pre-op and scan mm
  Surface scan;          ///< painted as the surface is
};
/// `amounts`: mm RMS of each of the six places; none of them: a stiff body.
[[nodiscard]] BeanTruth beanTruth(const std::vector<double>& amounts, double noiseMm);
/// The same of given displacements of the mesh's nodes.
[[nodiscard]] BeanTruth beanMoved(const Points& displacements, double noiseMm);

/// Mean distance of an update's inside places from the truth, mm.
[[nodiscard]] double meanError(const TetrahedralMesh& mesh, const UpdateResult& update,
                               const BeanTruth& truth);

}  // namespace falciform::test
