#pragma once
#include "Logic/Acquisition/ScanReturns.h"

namespace falciform {

/// The digital photograph that the scanner takes of its field of view (thesis ch. III), 1280 pixels wide, lit
/// from beside the camera: what faces it is bright, and the wet organ gleams. Gives `scan`, whose points are
/// still in the scene's frame, its texture, the points' places in it and their colours. What smoke hides is
/// photographed as if there were none.
void photographScan(const ScanScene& scene, const TriangleTree& tree, const ScannerView& view, Surface& scan);

}  // namespace falciform
