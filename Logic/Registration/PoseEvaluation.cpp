#include "Logic/Registration/PoseEvaluation.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "Logic/Core/Errors.h"
#include "Logic/Registration/RegistrationFigures.h"

namespace falciform {

namespace {

/// The scan's points; labels that the settings leave out, or that the other side lacks, count as none.
LabelledSource labelledScan(const PreparedPreop& preop, const Surface& scan,
                            const RegistrationSettings& settings) {
  LabelledSource source{scan.points, std::vector<int>(static_cast<std::size_t>(scan.size()), 0)};
  if (!looksAtPatches(settings)) return source;
  for (const int label : patchLabels(scan)) {
    const bool asked =
        settings.patches.empty() || std::count(settings.patches.begin(), settings.patches.end(), label) > 0;
    if (!asked || !preop.target().has(label)) continue;
    for (const int i : pointsOfPatch(scan, label)) source.labels[static_cast<std::size_t>(i)] = label;
  }
  return source;
}

}  // namespace

RegistrationResult evaluatePose(RegistrationResult pose, const PreparedPreop& preop, const Surface& scan,
                                const RegistrationSettings& settings, const Isometry3d& scanFromPreopStart) {
  const auto began = std::chrono::steady_clock::now();
  checkSettings(settings);
  checkSurface(scan, "scan");
  if (scan.size() < 3)
    throw InputError("scan has " + std::to_string(scan.size()) + " points; a pose needs at least 3");
  pose.patchRmsMm.clear();
  fillFigures(pose, preop, scan, KdTree(scan.points), labelledScan(preop, scan, settings), settings,
              scanFromPreopStart);
  // Why nothing settled here is said by the warnings that came with the pose.
  const bool converged = std::exchange(pose.converged, true);
  const std::vector<std::string> warnings = registrationWarnings(pose, preop.surface(), scan, settings);
  pose.converged = converged;
  pose.warnings.insert(pose.warnings.end(), warnings.begin(), warnings.end());
  pose.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return pose;
}

}  // namespace falciform
