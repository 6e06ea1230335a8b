#pragma once
#include "Logic/Acquisition/VirtualScanner.h"
#include "Logic/Core/Draws.h"

namespace falciform::bench {

/// How a liver is seen.
struct AimedView {
  double noiseMm = 0.5;
  double visibleShare = 0.3;  ///< of the surface's area: the scanner's window is cut to it
  int stride = 3;             ///< of the raster
};

/// A scanner before an open abdomen: in front, from the feet's side, aimed near the middle of the patches;
/// the direction and the aim are drawn. What one station cannot see because the liver is round, a second one
/// from 75 deg farther to the left adds. `seed` draws the noise and the scanner's frame. Coverage is exact to
/// about one per cent.
[[nodiscard]] VirtualScan scanAimed(const Surface& surface, const AimedView& view, int seed, Draws& draws);

}  // namespace falciform::bench
