#pragma once
#include "Logic/Core/Surface.h"
#include "Logic/Segmentation/Mask.h"

namespace falciform {

/// A front on its way, for the eye.
struct FrontPreview {
  LabelMap labels;  ///< 1 inside; the grid that the front moves on
  Surface surface;  ///< around it, LPS mm, of voxels of about 4 mm; empty if nothing is inside
};

/// Both of them from the voxels inside the front. Quick enough for several times a second on a whole CT.
[[nodiscard]] FrontPreview previewOf(const Mask& front);

/// Labels of 0 and 1 on the grid of `ct`: what lies more inside than outside, linear between `front`'s
/// voxels.
[[nodiscard]] LabelMap onGridOf(const Image& ct, const LabelMap& front);

}  // namespace falciform
