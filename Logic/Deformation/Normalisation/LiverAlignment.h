#pragma once
#include <Eigen/Geometry>

#include "Logic/Core/Progress.h"
#include "Logic/Deformation/Normalisation/FieldSamples.h"

namespace falciform {

/// The rigid and then the affine map that makes the source's distances at the samples most like the wanted
/// ones (Gauss-Newton, least squares of differences clamped to +-`bandMm`), from the start given. The
/// samples' places are in the target's frame.
[[nodiscard]] Eigen::Affine3d alignLivers(const GridField& source, const FieldSamples& target, double bandMm,
                                          const Eigen::Affine3d& start, const Progress& progress = {});

}  // namespace falciform
