#pragma once
#include "Logic/Acquisition/ScanPreparation.h"
#include "Widgets/Rendering/RenderedImage.h"

namespace falciform::commandline {

/// Three pictures beside each other from the scanner's side: the scan as it was, what becomes of its points,
/// and what is left.
[[nodiscard]] RenderedImage scanPicture(const MarkedScan& marked, const Surface& prepared);

}  // namespace falciform::commandline
