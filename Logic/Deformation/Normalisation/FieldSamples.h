#pragma once
#include <vector>

#include "Logic/Geometry/GridField.h"

namespace falciform {

/// Places of the target, where they lie now in the source's frame, and what the source's field should say
/// there.
struct FieldSamples {
  Points places;              ///< N x 3, mm, source frame
  std::vector<float> values;  ///< N values: the target's own field there
};

/// Places on a lattice of spacing `everyMm` nearer than `bandMm` to the target's surface, in its frame.
[[nodiscard]] FieldSamples samplesOf(const GridField& target, double bandMm, double everyMm);

}  // namespace falciform
