#pragma once
#include "Logic/Core/Surface.h"

namespace falciform {

/// Labels of `to` when every point takes the label of the nearest painted point of `from` within `radiusMm`
/// (thesis ch. III: 3 mm), both in one frame; nearer wins, ties go to the lower index; points beyond keep
/// label 0, or their own if `keepOld`.
[[nodiscard]] std::vector<int> transferPatches(const Surface& from, const Surface& to, double radiusMm = 3.0,
                                               bool keepOld = false);

}  // namespace falciform
