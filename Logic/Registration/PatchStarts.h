#pragma once
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Registration/PatchIcp.h"

namespace falciform {

/// `count` rotations spread evenly over SO(3), the same at every call (super-Fibonacci spirals, Alexa 2022).
[[nodiscard]] std::vector<Matrix3d> rotationGrid(int count);

/// A pose reached from one or more starts.
struct StartPose {
  Isometry3d preopFromScan = Isometry3d::Identity();
  double score = 0;  ///< robust residual in [0, 1], lower is better: mean of d^2 / (d^2 + (5 mm)^2), patch
                     ///< points counted threefold
  int starts = 1;
};

/// Poses worth refining, best first, one a basin (METHODS 2.4): for each rotation of an even grid the
/// patches' centroids are brought together and the patch points alone aligned; what differs by more than 10
/// mm is then refined on a subsample of the whole scan and scored. Needs at least one label that both sides
/// have.
[[nodiscard]] std::vector<StartPose> startsFromPatches(const LabelledTarget& target,
                                                       const LabelledSource& source,
                                                       const RegistrationSettings& settings,
                                                       const Progress& progress = {});

/// The score of StartPose.
[[nodiscard]] double robustScore(const LabelledTarget& target, const LabelledSource& source,
                                 double correspondenceWeight, const Isometry3d& preopFromScan);

/// Ids of about `perLabel` points of each label and `others` of none, spread evenly, ascending.
[[nodiscard]] std::vector<int> balancedSample(const LabelledSource& source, Index perLabel, Index others);

}  // namespace falciform
