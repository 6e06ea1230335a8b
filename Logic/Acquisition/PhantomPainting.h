#pragma once
#include "Logic/Acquisition/LiverShape.h"

namespace falciform {

/// The simulated falciform and inferior ridge regions as drawn on the phantom's whole scan (thesis Fig.
/// III.6): labels of points given in the liver's own coordinates, mm.
[[nodiscard]] std::vector<int> paintPhantomScan(const LiverShape& liver, const Points& points);

/// The part of the scan that a surgeon's scanner usually gets (thesis Fig. III.6), around the falciform
/// notch: ascending ids of points given in the liver's own coordinates, mm.
[[nodiscard]] std::vector<int> surgicalSubRegion(const LiverShape& liver, const Points& points);

}  // namespace falciform
