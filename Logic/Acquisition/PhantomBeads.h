#pragma once
#include <cstdint>

#include "Logic/Acquisition/LiverShape.h"
#include "Logic/Core/Landmarks.h"

namespace falciform {

/// The steel beads cast into the phantom of thesis ch. V (Fig. V.5), LPS mm, as targets inside: "bead 1" and
/// up, strewn over the whole liver.
struct PhantomBeadPlan {
  int count = 43;
  double depthMm = 5;  ///< of silicone over each, at least, by LiverShape's distance
  std::uint64_t seed = 1;
};

/// Each bead is the one of twenty drawn places that is farthest from the beads before it (Mitchell 1991), so
/// that none of the liver goes without. The first k beads are the same for any count. Throws InputError for a
/// count below 1, or where the liver has no such depth.
[[nodiscard]] Landmarks placeBeads(const LiverShape& liver, const PhantomBeadPlan& plan = {});

}  // namespace falciform
