#include "Logic/Registration/Trials/Trials.h"

#include <algorithm>
#include <limits>
#include <mutex>

#include "Logic/Core/ParallelJobs.h"
#include "Logic/Registration/PointRegistration.h"
#include "Logic/Registration/SurfaceRegistration.h"

namespace falciform {

namespace {

double turnDeg(const Isometry3d& motion) {
  return Eigen::AngleAxisd(motion.linear()).angle() * 180 / EIGEN_PI;
}

/// Sums up the reports of jobs that run beside each other; each of them stops as the whole does.
class JointProgress {
 public:
  JointProgress(const Progress& whole, std::size_t total, std::size_t done)
      : whole_(whole), total_(total), done_(done) {}

  [[nodiscard]] Progress ofOne() {
    return {[this](double, std::string_view) { stopWithTheWhole(); }, stop_.get_token()};
  }
  /// Call with the jobs' lock held.
  void oneMore() {
    ++done_;
    whole_.report(static_cast<double>(done_) / static_cast<double>(total_),
                  "Trials " + std::to_string(done_) + " of " + std::to_string(total_));
  }

 private:
  void stopWithTheWhole() {
    if (!whole_.stopRequested()) return;
    stop_.request_stop();
    throw Cancelled();
  }

  const Progress& whole_;
  std::stop_source stop_;
  std::size_t total_, done_;
};

}  // namespace

TrialCase trialCase(const PreparedPreop& preop, const Surface& scan, const TrialTargets& targets,
                    const GoldStandard& gold) {
  const Isometry3d preopFromScan = gold.scanFromPreop.inverse();
  TrialCase data{preop, transformed(scan, preopFromScan, scan.frame), targets.preop,
                 transformed(targets.scan, preopFromScan), Vector3d::Zero()};
  data.scanCentre = data.scan.points.colwise().mean();
  return data;
}

TrialRecord runTrial(const TrialCase& data, const TrialMethod& method, const TrialScale& scale,
                     const TrialSettings& settings, int trial, const Progress& progress) {
  const Isometry3d moved =
      perturbation(scale, settings.distribution, static_cast<std::uint64_t>(settings.seed),
                   static_cast<std::uint64_t>(trial), data.scanCentre);
  const Surface scan = variedScan(data.scan, settings.variation, static_cast<std::uint64_t>(settings.seed),
                                  static_cast<std::uint64_t>(trial));
  const RegistrationResult result = registerSurfaces(data.preop, transformed(scan, moved, data.scan.frame),
                                                     method.settings, Isometry3d::Identity(), progress);
  TrialRecord record;
  record.trial = trial;
  record.startRotationDeg = turnDeg(moved);
  record.startTranslationMm = (moved * data.scanCentre - data.scanCentre).norm();
  record.rmsMm = result.rmsMm;
  // The gold standard of the moved scan is the perturbation itself; in its frame the pose is what is wrong.
  record.error = moved.inverse() * result.scanFromPreop;
  const Points& vertices = data.preop.surface().points;
  record.goldDistanceMm = targetErrors(vertices, vertices, record.error).maxCoeff();
  const bool targets = data.targets.rows() > 0;
  record.targetErrorMm = targets ? targetErrors(data.targets, data.truth, record.error).mean()
                                 : std::numeric_limits<double>::quiet_NaN();
  record.success =
      targets ? record.targetErrorMm < settings.successTreMm : record.rmsMm < settings.successRmsMm;
  record.warnings = static_cast<int>(result.warnings.size());
  record.posesFound = static_cast<int>(result.basins.size());
  record.iterations = result.iterations;
  record.converged = result.converged;
  record.stopReason = result.stopReason;
  record.seconds = result.seconds;
  return record;
}

std::vector<TrialRecord> runTrials(const TrialCase& data, const std::vector<TrialMethod>& methods,
                                   const TrialScale& scale, const TrialSettings& settings,
                                   const std::vector<TrialRecord>& done,
                                   const std::function<void(const TrialRecord&)>& keep,
                                   const Progress& progress) {
  const std::size_t count = static_cast<std::size_t>(settings.count), all = count * methods.size();
  const auto placeOf = [&](const TrialRecord& record) {
    return static_cast<std::size_t>(record.method) * count + static_cast<std::size_t>(record.trial);
  };
  std::vector<TrialRecord> records(all);
  std::vector<char> there(all);
  for (const TrialRecord& record : done) {
    records[placeOf(record)] = record;
    there[placeOf(record)] = 1;
  }
  // All methods on one perturbation before the next, so that a run that is stopped has tried all alike.
  std::vector<std::pair<int, int>> open;
  for (int trial = 0; trial < settings.count; ++trial)
    for (int method = 0; method < static_cast<int>(methods.size()); ++method)
      if (!there[static_cast<std::size_t>(method) * count + static_cast<std::size_t>(trial)])
        open.emplace_back(method, trial);

  std::mutex guard;
  JointProgress joint(progress, all, all - open.size());
  forEachJob(open.size(), settings.atOnce, [&](std::size_t i) {
    const auto [method, trial] = open[i];
    TrialRecord record =
        runTrial(data, methods[static_cast<std::size_t>(method)], scale, settings, trial, joint.ofOne());
    record.method = method;
    const std::lock_guard lock(guard);
    if (keep) keep(record);
    records[placeOf(record)] = std::move(record);
    joint.oneMore();
  });
  return records;
}

}  // namespace falciform
