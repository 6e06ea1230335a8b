#pragma once
#include "Logic/Registration/Trials/Trials.h"
#include "Testing/Logic/Registration/PartialScan.h"

namespace falciform::test {

/// A body of 642 points with two patches, half of it scanned exactly, four targets inside; known truth.
struct SmallTrial {
  Surface body = lumpyBody(3);
  Isometry3d scanFromPreop = randomMotion(21);
  Surface scan = partialScan(body, Vector3d(0.2, -0.7, 0.9), 80, 1, scanFromPreop);
  PreparedPreop preop{body};
  TrialTargets targets = targetsInside();

  [[nodiscard]] TrialCase atGold(bool withTargets = true) const {
    return trialCase(preop, scan, withTargets ? targets : TrialTargets{},
                     goldStandard(preop, scan, targets, scanFromPreop));
  }

 private:
  [[nodiscard]] TrialTargets targetsInside() const {
    TrialTargets made;
    made.preop.resize(4, 3);
    made.preop << 10, 0, 0, -20, 15, 5, 30, -10, 20, 0, 25, -25;
    made.scan = transformed(made.preop, scanFromPreop);
    return made;
  }
};

}  // namespace falciform::test
