#pragma once
#include "Logic/Acquisition/LiverShape.h"

namespace falciform {

/// Labels of the patches at the surface's points: the falciform ligament's strip along its groove, and the
/// inferior ridge from the falciform notch to the right end of the liver (segments IV to VI).
[[nodiscard]] std::vector<int> paintPatches(const LiverShape& shape, const Points& points);

/// Vertices of the surface that a surgeon can find again: notch, tips, dome, gallbladder, falciform top,
/// caval bed.
[[nodiscard]] Landmarks anatomicalLandmarks(const LiverShape& shape, const Points& points);

}  // namespace falciform
