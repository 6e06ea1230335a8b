#pragma once
#include "Logic/Core/Surface.h"
#include "Testing/Benchmarks/Truths/TruthPlan.h"

namespace falciform::bench {

/// What a range scanner sees of the deformed liver, with patches, in its own frame.
struct TruthScan {
  Surface scan;
  Isometry3d scannerFromPreop = Isometry3d::Identity();
  double coverage = 0;  ///< share of the surface's area that was seen
};

/// The part of the raster is chosen so that the coverage comes near the plan's; noise along the rays;
/// outliers stand 5 to 40 mm before the surface, as smoke, blood and instruments do. `moved`: the deformed
/// surface in the pre-operative frame.
[[nodiscard]] TruthScan scanTruth(const Surface& moved, const ScannerPlan& plan);

}  // namespace falciform::bench
