#pragma once
#include "Logic/Core/Progress.h"
#include "Logic/Deformation/Normalisation/BasisWarp.h"
#include "Logic/Deformation/Normalisation/Similarity.h"

namespace falciform {

/// One level of the adaptive bases algorithm.
struct LevelPlan {
  double compressionLimit = 0.6;  ///< of BasisWarp::compression: keeps det J > 0
  double damping = 0.2;           ///< price of a coefficient, as a share of the mean of what the data say
  double idle = 0.02;             ///< a function is left out where what is off around it is below this
  double idleShare = 0.3;         ///< or below this share of the level's
  int steps = 3;                  ///< Gauss-Newton steps, fewer when they no longer pay
  double leastGain = 0.03;        ///< share of the cost that a step must save for another to follow
  int innerSteps = 15;            ///< conjugate gradients in each, fewer when
  double innerTolerance = 1e-3;   ///< the energy left is below this share
};

/// Finds the coefficients of `lattice` that make target and source most alike at the samples' `places`, in
/// the source's frame before this level. Only functions around which the two differ take part.
[[nodiscard]] BasisWarp fitLevel(const Similarity& similarity, const Points& places, BasisWarp lattice,
                                 const LevelPlan& plan, const Progress& progress = {});

}  // namespace falciform
