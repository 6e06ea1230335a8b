#pragma once
#include "Logic/Core/Progress.h"
#include "Logic/Core/Surface.h"

namespace falciform {

/// Incremental isotropic remeshing (Botsch and Kobbelt 2004): splits, collapses (link condition kept), flips,
/// tangential relaxation and projection onto the input surface, `passes` times. A closed manifold stays one.
/// Point data except coordinates is dropped. `edgeLengthMm` > 0: the mean edge length aimed at.
[[nodiscard]] Surface remeshIsotropic(const Surface& surface, double edgeLengthMm, int passes = 6,
                                      const Progress& progress = {});

}  // namespace falciform
