#pragma once
#include "Logic/Biomechanics/BoundaryFaces.h"
#include "Logic/Biomechanics/SupportSites.h"
#include "Logic/Core/TetrahedralMesh.h"

namespace falciform::test {

/// A shaken slab of quadratic tetrahedra, 120 x 60 x 40 mm, that stands for a liver: its back end is the vena
/// cava, the rest of its back the bed, its underside the two lobes'.
struct SlabLiver {
  TetrahedralMesh mesh;
  BoundaryFaces faces;
  SupportSites sites;
};
/// `tumour`: the elements around the middle are region 1.
[[nodiscard]] SlabLiver slabLiver(bool tumour = false);

/// Length of a field's longest vector, mm.
[[nodiscard]] double largest(const Points& field);

}  // namespace falciform::test
