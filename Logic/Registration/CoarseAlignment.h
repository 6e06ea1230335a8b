#pragma once
#include "Logic/Registration/PreparedPreop.h"
#include "Logic/Registration/ScanSample.h"

namespace falciform {

/// A pose that a search may keep.
struct StartPose {
  Isometry3d preopFromScan = Isometry3d::Identity();
  double score = 0;  ///< robust residual in [0, 1], lower is better: mean of d^2 / (d^2 + (5 mm)^2), patch
                     ///< points counted threefold, a point whose normal faces the wrong way as a miss
  int starts = 1;    ///< how many starts ended here
};

/// How hard labelled points pull to their own label, against one that is not labelled: from `first` down to
/// `last` over the iterations, by a constant factor each.
struct CoarsePull {
  double first = 0, last = 0;
  double surface = 1;  ///< weight of all points' pull to the surface; 0: labels alone
};

/// Rigid closest-point alignment for searches: point-to-plane with a little point-to-point, robust, over the
/// maps of closest points. A few microseconds a step for a few hundred points. Needs preop.normals().
/// `iterations` at most; stops when nothing moves by 0.1 mm and the pull has reached its last value.
void alignCoarsely(const PreparedPreop& preop, const ScanSample& sample, const CoarsePull& pull,
                   int iterations, StartPose& pose);

/// Sets the score of `pose`.
void scoreCoarsely(const PreparedPreop& preop, const ScanSample& sample, StartPose& pose);

}  // namespace falciform
