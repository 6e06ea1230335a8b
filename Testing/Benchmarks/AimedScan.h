#pragma once
#include <vector>

#include "Logic/Acquisition/VirtualScanner.h"
#include "Logic/Core/Draws.h"

namespace falciform::bench {

/// Where a scanner stands, what it is aimed at and how wide its window is.
struct Station {
  VirtualScannerSettings scanner;
  Vector3d lookAt = Vector3d::Zero();
};

/// A scanner before an open abdomen: in front, from the feet's side, aimed near the middle of the patches;
/// the direction and the aim are drawn. Its window is cut so that `visibleShare` of the surface's area is
/// seen, to about one per cent of the area. What one station cannot see because the liver is round, a second
/// one adds from 75 deg farther to the left.
[[nodiscard]] std::vector<Station> aimStations(const Surface& surface, double visibleShare, Draws& draws);

/// What the stations see, in one frame. `stride`: of the raster. `seed` draws noise and frame.
[[nodiscard]] VirtualScan scanFrom(const std::vector<Station>& stations, const Surface& surface,
                                   double noiseMm, int stride, int seed);

}  // namespace falciform::bench
