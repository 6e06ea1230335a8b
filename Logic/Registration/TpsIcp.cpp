#include <algorithm>
#include <cmath>
#include <limits>

#include "Logic/Geometry/Sampling.h"
#include "Logic/Registration/ClosestPointLoop.h"
#include "Logic/Registration/NonRigidRegistration.h"

namespace falciform {

namespace {

constexpr Index kSample = 600;
constexpr double kStiffest = 1, kSoftest = 3e-2;  // of ThinPlateFit
constexpr double kSoftening = 0.7;                // per stage
constexpr int kIterationsPerStage = 5;
constexpr double kRigidToleranceMm = 0.05;

}  // namespace

NonRigidResult registerTpsIcp(const PreparedPreop& preop, const Surface& scan,
                              const RegistrationSettings& settings, const Isometry3d& start,
                              const Progress& progress, const IterationObserver& observer) {
  const ClosestOnPreop surface(preop);
  const Points sample = rowsOf(scan.points, spreadSample(scan.points, kSample));
  const MatchPoints match = [&](const Points& moved, Points& matched) { surface.closest(moved, matched); };
  RegistrationSettings first = settings;
  first.motionToleranceMm = std::max(settings.motionToleranceMm, kRigidToleranceMm);
  PatchIcpResult run = runClosestPointLoop(sample, match, first, start, progress.part(0, 0.5), observer);

  const ThinPlateFit fitter(sample, knotsFor(sample));
  Points moved = transformed(sample, run.preopFromScan), matched;
  VectorXd weights = VectorXd::Ones(sample.rows());
  run.converged = false;
  run.stopReason = "the largest number of iterations was reached";
  for (double stiffness = kStiffest; !run.converged;) {
    double motion = 0;
    for (int k = 0; k < kIterationsPerStage; ++k) {
      if (static_cast<int>(run.history.size()) >= settings.maxIterations) break;
      surface.closest(moved, matched);
      const VectorXd distances = (moved - matched).rowwise().norm();
      weights = robustWeights(distances, settings);
      const ThinPlateSpline warp = fitter.fit(matched, weights, stiffness);
      const Points next = warp(sample);
      motion = (next - moved).rowwise().norm().maxCoeff();
      moved = next;
      IterationRecord record;
      record.iteration = static_cast<int>(run.history.size()) + 1;
      record.rmsMm = std::sqrt(distances.squaredNorm() / static_cast<double>(distances.size()));
      record.motionMm = motion;
      record.preopFromScan = run.preopFromScan = warp.rigid();
      noteIteration(run, record, 0.5 + 0.5 * std::log(stiffness) / std::log(kSoftest), progress, observer);
    }
    if (static_cast<int>(run.history.size()) >= settings.maxIterations) break;
    if (stiffness <= kSoftest) {
      run.converged = true;
      run.stopReason = "the spline had reached its softest";
    }
    stiffness = std::max(kSoftest, stiffness * kSoftening);
  }
  surface.closest(moved, matched);
  return nonRigidFromPairs(preop, matched, sample, weights, kSoftest, std::move(run));
}

}  // namespace falciform
