#include "Logic/Registration/SurfaceRegistration.h"

#include <algorithm>
#include <chrono>

#include "Logic/Core/Errors.h"
#include "Logic/Registration/PatchIcp.h"
#include "Logic/Registration/PatchStarts.h"
#include "Logic/Registration/RegistrationFigures.h"

namespace falciform {

namespace {

constexpr Index kCoarsePoints = 2000, kCoarsePerPatch = 300;

/// Labels that both sides have, or those asked for; throws InputError if one asked for is missing.
std::vector<int> sharedLabels(const Surface& preop, const Surface& scan,
                              const RegistrationSettings& settings) {
  if (settings.method == RegistrationMethod::Icp) return {};
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

void checkInput(const Surface& scan, const RegistrationSettings& settings) {
  checkSettings(settings);
  checkSurface(scan, "scan");
  if (scan.size() < 3)
    throw InputError("scan has " + std::to_string(scan.size()) + " points; a pose needs at least 3");
  if (settings.weightBase > settings.weightMax)
    throw InputError(
        "weightBase is larger than weightMax; the patch weight falls from weightMax to weightBase");
}

/// The scan's points; a label that is not in use counts as none.
LabelledSource sourceOf(const Surface& scan, const std::vector<int>& labels) {
  LabelledSource source{scan.points, std::vector<int>(static_cast<std::size_t>(scan.size()), 0)};
  for (Index i = 0; i < scan.size(); ++i)
    if (std::binary_search(labels.begin(), labels.end(), scan.patchAt(i)))
      source.labels[static_cast<std::size_t>(i)] = scan.patchAt(i);
  return source;
}

/// While the patches' pull relaxes, a spread sample does as well as the whole scan; the whole scan then has
/// the last word. The thesis's stop rule runs on the whole scan alone, as the thesis did.
PatchIcpResult refine(const LabelledTarget& target, const LabelledSource& source,
                      const RegistrationSettings& settings, const Isometry3d& start, const Progress& progress,
                      const IterationObserver& observer) {
  if (settings.stop == StopRule::Rms || source.points.rows() <= 2 * kCoarsePoints)
    return runPatchIcp(target, source, settings, start, 1, progress, observer);
  RegistrationSettings coarse = settings;
  coarse.motionToleranceMm = std::max(settings.motionToleranceMm, 0.02);
  const LabelledSource sample = subsetOf(source, balancedSample(source, kCoarsePerPatch, kCoarsePoints));
  PatchIcpResult first = runPatchIcp(target, sample, coarse, start, 1, progress.part(0, 0.5), observer);
  RegistrationSettings fine = settings;
  const int done = static_cast<int>(first.history.size());
  fine.maxIterations = std::max(1, settings.maxIterations - done);
  PatchIcpResult second =
      runPatchIcp(target, source, fine, first.preopFromScan, done + 1, progress.part(0.5, 1), observer);
  second.history.insert(second.history.begin(), first.history.begin(), first.history.end());
  return second;
}

}  // namespace

RegistrationResult registerSurfaces(const PreparedPreop& prepared, const Surface& scan,
                                    const RegistrationSettings& settings,
                                    const Isometry3d& scanFromPreopStart, const Progress& progress,
                                    const IterationObserver& observer) {
  const auto began = std::chrono::steady_clock::now();
  checkInput(scan, settings);
  const Surface& preop = prepared.surface();
  const LabelledTarget& target = prepared.target();
  const LabelledSource source = sourceOf(scan, sharedLabels(preop, scan, settings));
  const bool painted =
      std::any_of(source.labels.begin(), source.labels.end(), [](int label) { return label > 0; });
  const bool fromPatches = settings.start == RegistrationStart::Patches && painted;

  std::vector<StartPose> starts{{scanFromPreopStart.inverse(), 0, 1}};
  if (fromPatches) starts = startsFromPatches(target, source, settings, progress.part(0, 0.5));
  const PatchIcpResult run = refine(target, source, settings, starts.front().preopFromScan,
                                    progress.part(fromPatches ? 0.5 : 0, 0.95), observer);

  RegistrationResult result;
  result.scanFromPreop = run.preopFromScan.inverse();
  result.history = run.history;
  result.iterations = static_cast<int>(run.history.size());
  result.converged = run.converged;
  result.stopReason = run.stopReason;
  for (const StartPose& start : starts)
    result.basins.push_back({start.preopFromScan.inverse(), start.score, start.starts});
  const LabelledSource sample = subsetOf(source, balancedSample(source, kCoarsePerPatch, kCoarsePoints));
  result.basins.front().scanFromPreop = result.scanFromPreop;
  result.basins.front().score = robustScore(target, sample, settings.correspondenceWeight, run.preopFromScan);
  fillFigures(result, preop, scan, target, source, settings, scanFromPreopStart);
  result.warnings = registrationWarnings(result, preop, scan, settings);
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
