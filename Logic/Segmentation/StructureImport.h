#pragma once
#include "Logic/Core/Surface.h"
#include "Logic/Core/Volume.h"

namespace falciform {

/// A vessel or tumour of a label map as a closed surface, LPS mm: marching cubes around all its pieces,
/// lightly smoothed so that thin branches stay. Throws InputError if no voxel has the label.
[[nodiscard]] Surface structureSurface(const LabelMap& map, int label);

}  // namespace falciform
