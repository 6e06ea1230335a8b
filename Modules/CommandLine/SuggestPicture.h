#pragma once
#include "Logic/Patches/FeatureGround.h"
#include "Widgets/Rendering/RenderedImage.h"

namespace falciform::commandline {

/// The painted surface from the front and from the front and below, side by side, drawn without a display.
[[nodiscard]] RenderedImage suggestPicture(const Surface& painted, const AnatomicalAxes& axes);

}  // namespace falciform::commandline
