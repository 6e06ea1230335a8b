#pragma once
#include "Logic/Atlas/ModelUpdate.h"
#include "Logic/Core/Volume.h"
#include "Widgets/Rendering/RenderedImage.h"

namespace falciform::commandline {

/// An axial cut through a CT before and after bending, as radiologists look at it (the patient's right at the
/// left, front at the top), with the liver's outline: as it was, and as it is now, the old one dashed.
struct SlicePictures {
  RenderedImage before, after;
};

/// The cut goes through the place of the surface that has bent most in the plane. `after` is in bent
/// coordinates, as `bendImage` makes it; `preop` and `mesh` are the update's.
[[nodiscard]] SlicePictures slicePictures(const Image& before, const Image& after, const Surface& preop,
                                          const TetrahedralMesh& mesh, const UpdateResult& update);

}  // namespace falciform::commandline
