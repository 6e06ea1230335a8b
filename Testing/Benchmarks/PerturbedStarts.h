#pragma once
#include <functional>
#include <string>

#include "Testing/Benchmarks/ThesisMethods.h"

namespace falciform::bench {

/// The perturbation trial of thesis ch. V, Fig. V.11.
struct PerturbedPlan {
  int starts = 25;
  double turnDeg = 5, shiftMm = 5;  ///< each of three angles and three shifts evenly in +- this
  std::uint64_t seed = 11;
};

/// What a method answers from many starts.
struct PerturbedOutcome {
  std::string method;
  int starts = 0;
  ErrorFigures meanMm;    ///< of the mean error over the beads, over starts
  double farthestMm = 0;  ///< between two starts' answers for one bead
  VectorXd errorsMm;      ///< of all beads from all starts
};

using Method = std::function<MethodOutcome(const Isometry3d& scanFromPreopStart)>;

/// Runs `method` from `pose` turned about the scan's middle and shifted, once per start.
[[nodiscard]] PerturbedOutcome perturbed(const std::string& name, const Surface& scan, const Isometry3d& pose,
                                         const Method& method, const PerturbedPlan& plan = {});

}  // namespace falciform::bench
