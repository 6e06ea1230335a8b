#pragma once
#include "Logic/Core/Progress.h"
#include "Logic/Deformation/Normalisation/BasisWarp.h"
#include "Logic/Deformation/Normalisation/DistanceSamples.h"

namespace falciform {

/// One level of the adaptive bases algorithm.
struct LevelPlan {
  double bandMm = 10;             ///< distances are compared up to this far from the surfaces
  double compressionLimit = 0.6;  ///< of BasisWarp::compression: keeps det J > 0
  double damping = 0.1;           ///< price of a coefficient, as a share of the mean of what the data say
  double idleMm = 0.02;           ///< a function is left out where the differences around it are below this
  double idleShare = 0.3;         ///< and below this share of the level's
  int steps = 3;                  ///< Gauss-Newton steps, fewer when they no longer pay
  int innerSteps = 15;            ///< conjugate gradients in each, fewer when
  double innerTolerance = 1e-3;   ///< the energy left is below this share
};

/// Finds the coefficients of `lattice` that bring the source's distances at the samples nearest the wanted
/// ones (least squares), moves the samples by the warp found, and returns it. Only functions around which the
/// two differ take part.
[[nodiscard]] BasisWarp fitLevel(const GridField& source, DistanceSamples& samples, BasisWarp lattice,
                                 const LevelPlan& plan, const Progress& progress = {});

}  // namespace falciform
