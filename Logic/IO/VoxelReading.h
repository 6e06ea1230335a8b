#pragma once
#include "Logic/Core/Volume.h"
#include "Logic/IO/Loaded.h"
#include "Logic/IO/VolumeLayout.h"

namespace falciform {

/// The voxels that `layout` describes, as labels: throws InputError for a value that is no whole number in
/// 0..65535, for truncated or damaged data, and for more voxels than the file can hold.
[[nodiscard]] Loaded<LabelMap> readLabels(VolumeLayout layout);
/// The same as intensities; warns of values that are not finite.
[[nodiscard]] Loaded<Image> readIntensities(VolumeLayout layout);

}  // namespace falciform
