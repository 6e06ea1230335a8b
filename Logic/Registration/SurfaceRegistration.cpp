#include "Logic/Registration/SurfaceRegistration.h"

#include <algorithm>
#include <chrono>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Registration/ElasticFit.h"
#include "Logic/Registration/MethodDispatch.h"
#include "Logic/Registration/PatchIcp.h"
#include "Logic/Registration/PoseSearch.h"
#include "Logic/Registration/RegistrationFigures.h"

namespace falciform {

namespace {

constexpr Index kSearchPoints = 300, kSearchPerPatch = 60;  // stand for the scan in a search
constexpr Index kRankPoints = 400, kNearPoints = 1000, kFinishPoints = 4000;  // and in the elastic fit
constexpr Index kLoopPoints = 2000;  // and in the loop, before the finish
constexpr std::size_t kRanked = 6;   // so many basins are compared by what the elastic fit makes of them

/// Labels that both sides have, or those asked for; throws InputError if one asked for is missing.
std::vector<int> sharedLabels(const Surface& preop, const Surface& scan,
                              const RegistrationSettings& settings) {
  if (settings.method == RegistrationMethod::Icp || settings.method == RegistrationMethod::Auto) return {};
  const std::vector<int> onPreop = patchLabels(preop), onScan = patchLabels(scan);
  const auto has = [](const std::vector<int>& labels, int label) {
    return std::binary_search(labels.begin(), labels.end(), label);
  };
  for (const int label : settings.patches)
    for (const auto& [labels, side] : {std::pair(&onPreop, "pre-op surface"), std::pair(&onScan, "scan")})
      if (!has(*labels, label))
        throw InputError("patch " + std::to_string(label) + " (" + patchName(preop, label) +
                         ") is empty on the " + side + "; paint it there or leave it out");
  std::vector<int> shared;
  for (const int label : onPreop)
    if (has(onScan, label) &&
        (settings.patches.empty() || std::count(settings.patches.begin(), settings.patches.end(), label)))
      shared.push_back(label);
  return shared;
}

void checkInput(const PreparedPreop& preop, const Surface& scan, const RegistrationSettings& settings) {
  checkSettings(settings);
  checkSurface(scan, "scan");
  if (scan.size() < 3)
    throw InputError("scan has " + std::to_string(scan.size()) + " points; a pose needs at least 3");
  if (settings.weightBase > settings.weightMax)
    throw InputError(
        "weightBase is larger than weightMax; the patch weight falls from weightMax to weightBase");
  if (settings.method == RegistrationMethod::Auto && preop.surface().triangles.rows() == 0)
    throw InputError("the pre-op surface has no triangles, which the method auto needs; give a mesh");
}

/// The scan's points; a label that is not in use counts as none.
LabelledSource sourceOf(const Surface& scan, const std::vector<int>& labels) {
  LabelledSource source{scan.points, std::vector<int>(static_cast<std::size_t>(scan.size()), 0)};
  for (std::size_t i = 0; i < scan.patch.size(); ++i)
    if (scan.patch[i] > 0 && std::binary_search(labels.begin(), labels.end(), scan.patch[i]))
      source.labels[i] = scan.patch[i];
  return source;
}

/// One registration in the making.
struct Task {
  const PreparedPreop& preop;
  const Surface& scan;
  LabelledSource source;
  KdTree scanTree;
  RegistrationSettings settings;
  const Progress& progress;
  const IterationObserver& observer;
  bool elastic = false;
  std::vector<int> clean{};       ///< rows of the scan that the elastic fits may use
  std::vector<int> spaceOrder{};  ///< of all rows

  [[nodiscard]] bool painted() const {
    return std::any_of(source.labels.begin(), source.labels.end(), [](int label) { return label > 0; });
  }
  /// `count` points at random, without stragglers.
  [[nodiscard]] LabelledSource part(Index count) const {
    std::vector<char> drawn(source.labels.size(), 0);
    for (const int i : randomRows(static_cast<Index>(clean.size()), count))
      drawn[static_cast<std::size_t>(clean[static_cast<std::size_t>(i)])] = 1;
    std::vector<int> rows;
    for (const int row : spaceOrder)
      if (drawn[static_cast<std::size_t>(row)]) rows.push_back(row);
    return subsetOf(source, rows);
  }
};

/// Every basin that the search finds; with the elastic finish the best are compared by it.
std::vector<StartPose> search(const Task& task, const Progress& progress) {
  const ScanSample sample = sampleScan(task.source, task.scanTree, kSearchPoints, kSearchPerPatch);
  std::vector<StartPose> starts = task.painted()
                                      ? startsFromPatches(task.preop, sample, progress.part(0, 0.7))
                                      : startsFromSurface(task.preop, sample, progress.part(0, 0.7));
  if (!task.elastic) return starts;
  // What fits far worse than the best before it may bend is a basin of its own, but no rival.
  const double rival = 1.5 * starts.front().score + 0.05;
  const auto hopeless =
      std::find_if(starts.begin(), starts.end(), [&](const StartPose& s) { return s.score > rival; });
  std::vector<StartPose> others(hopeless, starts.end());
  starts.erase(hopeless, starts.end());
  starts.resize(std::min(starts.size(), kRanked));
  const LabelledSource few = task.part(kRankPoints);
  ElasticFitPlan quick;
  quick.maxIterations = 8;
  quick.motionToleranceMm = 0.1;
  quick.patchWeight = task.settings.weightBase;
  forEachChunk(starts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !progress.stopRequested(); ++i) {
      const ElasticFitResult fit = fitElastic(task.preop, few, quick, starts[i].preopFromScan);
      starts[i].preopFromScan = fit.pose.preopFromScan;
      starts[i].score = fit.score;
    }
  });
  progress.report(1);
  starts.insert(starts.end(), others.begin(), others.end());
  keepDistinct(starts, boxCorners(few.points), kRanked);
  return starts;
}

/// The loop of chapter III from one start: on the whole scan, or on a sample where the finish follows.
PatchIcpResult loop(const Task& task, const Isometry3d& start, const Progress& progress) {
  if (!task.elastic)
    return runPatchIcp(task.preop.target(), task.source, task.settings, start, 1, progress, task.observer);
  RegistrationSettings coarse = task.settings;
  coarse.motionToleranceMm = std::max(coarse.motionToleranceMm, 0.05);
  return runPatchIcp(task.preop.target(), task.part(kLoopPoints), coarse, start, 1, progress, task.observer);
}

void finish(const Task& task, const PatchIcpResult& from, const Progress& progress,
            RegistrationResult& result, PatchIcpResult& run) {
  ElasticFitPlan settings;
  settings.patchWeight = task.settings.weightBase;
  run = from;
  // Few points until little moves, then many for the last tenths.
  ElasticFitResult fit;
  for (const Index points : {kNearPoints, kFinishPoints}) {
    const bool last = points == kFinishPoints;
    settings.learn = last;
    settings.motionToleranceMm = last ? 0.02 : 0.1;
    settings.maxIterations = last ? 30 : 12;
    settings.firstIteration = static_cast<int>(run.history.size()) + 1;
    fit = fitElastic(task.preop, task.part(points), settings, run.preopFromScan,
                     last ? progress.part(0.5, 1) : progress.part(0, 0.5), task.observer);
    settings.bending = fit.bending;
    fit.pose.history.insert(fit.pose.history.begin(), run.history.begin(), run.history.end());
    run = fit.pose;
  }
  result.expectedTargetErrorMm = expectedTargetError(task.preop.modes(), fit);
  result.expectedErrorMeanMm = expectedTargetErrorMean(task.preop.modes(), fit);
}

}  // namespace

RegistrationResult registerSurfaces(const PreparedPreop& preop, const Surface& scan,
                                    const RegistrationSettings& settings,
                                    const Isometry3d& scanFromPreopStart, const Progress& progress,
                                    const IterationObserver& observer) {
  const auto began = std::chrono::steady_clock::now();
  checkInput(preop, scan, settings);
  Task task{preop,
            scan,
            sourceOf(scan, sharedLabels(preop.surface(), scan, settings)),
            KdTree(scan.points),
            settings,
            progress,
            observer};
  const bool mesh = preop.surface().triangles.rows() > 0;
  task.elastic = settings.finish == RegistrationFinish::Elastic && mesh &&
                 settings.method != RegistrationMethod::Icp && !isOtherMethod(settings.method);
  if (task.elastic) {
    task.clean = withoutStragglers(scan.points, task.scanTree, randomRows(scan.size(), kFinishPoints));
    task.spaceOrder = task.scanTree.inSpaceOrder();
  }
  const bool bare = task.elastic && !task.painted() && settings.start == RegistrationStart::Patches;
  const bool global = mesh && (settings.method == RegistrationMethod::Auto || bare ||
                               (settings.start == RegistrationStart::Patches && task.painted()));

  std::vector<StartPose> starts{{scanFromPreopStart.inverse(), 0, 1}};
  PatchIcpResult run;
  if (global) starts = search(task, progress.part(0, 0.5));
  run.preopFromScan = starts.front().preopFromScan;
  OtherMethodResult other;
  if (isOtherMethod(settings.method)) {
    other = runOtherMethod(preop, scan, settings, run.preopFromScan, progress.part(global ? 0.5 : 0, 0.95),
                           observer);
    run = std::move(other.run);
  } else if (!global || !task.elastic) {
    run = loop(task, run.preopFromScan, progress.part(global ? 0.5 : 0, task.elastic ? 0.6 : 0.95));
  }

  RegistrationResult result;
  result.warp = std::move(other.warp);
  if (task.elastic) finish(task, PatchIcpResult(run), progress.part(0.6, 0.95), result, run);
  result.scanFromPreop = run.preopFromScan.inverse();
  result.history = run.history;
  result.iterations = static_cast<int>(run.history.size());
  result.converged = run.converged;
  result.stopReason = run.stopReason;
  for (const StartPose& start : starts)
    result.basins.push_back({start.preopFromScan.inverse(), start.score, start.starts});
  result.basins.front().scanFromPreop = result.scanFromPreop;
  fillFigures(result, preop, scan, task.scanTree, task.source, settings, scanFromPreopStart);
  if (bare && settings.method != RegistrationMethod::Auto)
    result.warnings.push_back("no patch is painted on both sides: the pose was searched on the bare surface");
  const std::vector<std::string> warnings = registrationWarnings(result, preop.surface(), scan, settings);
  result.warnings.insert(result.warnings.end(), warnings.begin(), warnings.end());
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  progress.report(1, "registered");
  return result;
}

RegistrationResult registerSurfaces(const Surface& preop, const Surface& scan,
                                    const RegistrationSettings& settings,
                                    const Isometry3d& scanFromPreopStart, const Progress& progress,
                                    const IterationObserver& observer) {
  checkSettings(settings);
  return registerSurfaces(PreparedPreop(preop), scan, settings, scanFromPreopStart, progress, observer);
}

}  // namespace falciform
