#pragma once
#include <functional>
#include <string>
#include <vector>

#include "Logic/Registration/Trials/GoldStandard.h"
#include "Logic/Registration/Trials/Perturbations.h"
#include "Logic/Registration/Trials/ScanVariation.h"
#include "Logic/Registration/Trials/TrialMethod.h"

namespace falciform {

struct TrialSettings {
  int count = 250;
  TrialDistribution distribution = TrialDistribution::Euler;
  double successTreMm = 5;  ///< target error below this is success, where there are targets
  double successRmsMm = 5;  ///< RMS residual below this is success, where there are none
  double goldWithinMm = 5;  ///< within the gold standard: no pre-op vertex lies farther off
  double basinMm = 5;       ///< poses that place every vertex within this are one basin
  int atOnce = 0;           ///< registrations beside each other; 0: as many as threads
  int seed = 1;
  ScanVariation variation;  ///< described on its own
};

template <class Visitor>
void describe(TrialSettings& s, Visitor&& field) {
  field(FieldInfo{"count", "Trials", "", 1, 1000000, "Perturbations that each method is tried on."}, s.count);
  field(
      FieldInfo{"distribution", "Distribution", "", 0, 0,
                "euler: each axis's angle uniform, as the thesis; uniform: on SO(3), among the rotations by "
                "at most the scale's angle."},
      s.distribution);
  field(FieldInfo{"successTreMm", "Success: target error", "mm", 1e-3, 1000,
                  "A trial succeeds below this mean target error, where targets are given."},
        s.successTreMm);
  field(FieldInfo{"successRmsMm", "Success: RMS", "mm", 1e-3, 1000,
                  "A trial succeeds below this RMS residual, where no targets are given."},
        s.successRmsMm);
  field(FieldInfo{"goldWithinMm", "Near the gold standard", "mm", 1e-3, 1000,
                  "Also counted: poses that place every pre-op vertex within this of the gold standard."},
        s.goldWithinMm);
  field(FieldInfo{"basinMm", "Basin", "mm", 1e-3, 1000,
                  "Results that place the surface's outermost points within this are the same pose."},
        s.basinMm);
  field(FieldInfo{"atOnce", "At once", "", 0, 1024,
                  "Registrations beside each other; 0: as many as threads. 1 gives honest times: all threads "
                  "then work on one registration."},
        s.atOnce);
  field(FieldInfo{"seed", "Seed", "", 0, 2147483647, "Draws the perturbations."}, s.seed);
}

/// What a set of trials is run on. All in the pre-op frame, mm: the scan and the true targets lie where the
/// gold standard puts them.
struct TrialCase {
  const PreparedPreop& preop;
  Surface scan;         ///< frame: the name of the scan's own
  Points targets;       ///< N x 3, N may be 0
  Points truth;         ///< N x 3, where the targets truly are
  Vector3d scanCentre;  ///< centroid of `scan`: what perturbations turn about
};
[[nodiscard]] TrialCase trialCase(const PreparedPreop& preop, const Surface& scan,
                                  const TrialTargets& targets, const GoldStandard& gold);

/// What became of one registration.
struct TrialRecord {
  int method = 0, trial = 0;                            ///< both from 0
  double startRotationDeg = 0, startTranslationMm = 0;  ///< of the perturbation; of the scan's centroid
  bool success = false;
  double targetErrorMm = 0;  ///< mean over the targets; NaN: none
  double rmsMm = 0;
  double goldDistanceMm = 0;  ///< greatest distance of a pre-op vertex from where the gold standard puts it
  int warnings = 0;           ///< how many the registration gave
  int posesFound = 0;         ///< length of its list of basins
  int iterations = 0;
  bool converged = false;
  std::string stopReason;
  Isometry3d error = Isometry3d::Identity();  ///< the pose against the gold standard's, pre-op mm: identity
                                              ///< is the gold standard
  double seconds = 0;
};

/// Registers trial `trial` with one method: the scan itself, varied, is moved by the perturbation and
/// registered from the identity, so that methods that look for a start of their own are tried on different
/// input each time.
[[nodiscard]] TrialRecord runTrial(const TrialCase& data, const TrialMethod& method, const TrialScale& scale,
                                   const TrialSettings& settings, int trial, const Progress& progress = {});

/// Every method on every perturbation; sorted by method, then trial. Those in `done` are taken as they are
/// and not run again; each new one is handed to `keep`, one at a time, as soon as it is there. The result
/// depends on neither the threads nor the order of work (times apart).
[[nodiscard]] std::vector<TrialRecord> runTrials(const TrialCase& data,
                                                 const std::vector<TrialMethod>& methods,
                                                 const TrialScale& scale, const TrialSettings& settings,
                                                 const std::vector<TrialRecord>& done = {},
                                                 const std::function<void(const TrialRecord&)>& keep = {},
                                                 const Progress& progress = {});

}  // namespace falciform
