#pragma once
#include "Modules/CommandLine/PictureTiles.h"

namespace falciform::commandline {

/// Both from the side that shows most, coloured by mean curvature on one scale.
[[nodiscard]] RenderedImage smoothPicture(const Surface& before, const Surface& after);

}  // namespace falciform::commandline
