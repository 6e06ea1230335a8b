#pragma once
#include <array>
#include <vector>

#include "Logic/Atlas/Atlas.h"
#include "Testing/Benchmarks/UpdateTrial.h"

namespace falciform::bench {

/// One trial of thesis Tables V.1 and V.2: gravity turned at random, and what is then seen of the liver.
struct GravityTrial {
  double yDeg = 0, zDeg = 0;  ///< turns of gravity, each drawn from [-50, 50]
  UpdateTrial full, partial;  ///< the same state; places are the nodes of the truth's mesh
  ErrorFigures before;        ///< how far the nodes have moved
  double coverage = 0;        ///< of the partial scan
  double minDetJ = 1;         ///< of the truth
};

/// The built-in liver, the thesis's atlas of 121 directions of gravity on it, and five trials.
struct GravityExperiment {
  Surface preop;
  Atlas atlas;
  std::vector<GravityTrial> inside;  ///< truth from the atlas's own span: an inverse crime
};

/// What is meshed how finely, and how well the scanner sees.
struct GravityPlan {
  double surfaceEdgeMm = 3;
  double meshEdgeMm = 10;
  double noiseMm = 0;  ///< of the partial scan; the thesis has none
  int trials = 5;
  std::uint64_t seed = 1;
};

[[nodiscard]] GravityExperiment gravityExperiment(const GravityPlan& plan);

/// The same five turns of gravity as nothing in the atlas's span answers them: CalculiX, neo-Hookean, large
/// displacement, a mesh of its own, and the liver held by a bare area instead of a sliding bed. Throws
/// std::runtime_error where CalculiX is missing.
[[nodiscard]] std::vector<GravityTrial> trialsOutsideTheSpan(const GravityExperiment& experiment,
                                                             const GravityPlan& plan);

}  // namespace falciform::bench
