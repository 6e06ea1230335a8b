#pragma once
#include <array>
#include <vector>

#include "Logic/Atlas/Atlas.h"
#include "Testing/Benchmarks/UpdateTrial.h"

namespace falciform::bench {

/// One trial of thesis Tables V.1 and V.2: gravity turned at random, and what is then seen of the liver.
struct GravityTrial {
  double yDeg = 0, zDeg = 0;  ///< turns of gravity, each drawn from [-50, 50]
  /// The same state as all vertices of the surface, as those that a scanner sees (both exact, as in the
  /// thesis), and as the noisy scan itself. Places are the nodes of the truth's mesh.
  UpdateTrial full, partial, scanned;
  ErrorFigures before;  ///< how far the nodes have moved
  double coverage = 0;  ///< of the scan
  double minDetJ = 1;   ///< of the truth
};

/// The built-in liver, the thesis's atlas of 121 directions of gravity on it, and five trials.
struct GravityExperiment {
  Surface preop;
  Atlas atlas;
  /// Truth from the atlas's own span and mesh, an inverse crime: linear, as the thesis's, which swells what
  /// it turns; and the same with turns made true (CornerWarp), as our fit bends.
  std::vector<GravityTrial> inside, turned;
};

/// What is meshed how finely, and how well the scanner sees.
struct GravityPlan {
  double surfaceEdgeMm = 2.45;  ///< the fits subdivide what is coarser than 2.5
  double meshEdgeMm = 10;
  double noiseMm = 0.5;  ///< of the scan
  int trials = 5;
  std::uint64_t seed = 1;
};

[[nodiscard]] GravityExperiment gravityExperiment(const GravityPlan& plan);

}  // namespace falciform::bench
