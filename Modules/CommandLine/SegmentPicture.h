#pragma once
#include "Logic/Core/Volume.h"
#include "Widgets/Rendering/RenderedImage.h"

namespace falciform::commandline {

/// Six axial cuts through the organ, bottom first, with its outline and the seeds that lie within 10 mm of
/// the cut. `labels` lies on the CT's grid.
[[nodiscard]] RenderedImage segmentPicture(const Image& ct, const LabelMap& labels, const Points& seeds);

}  // namespace falciform::commandline
