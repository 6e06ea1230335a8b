#include "Logic/Registration/RegistrationLogic.h"

#include <algorithm>
#include <cstdio>
#include <memory>

#include "Logic/Core/Errors.h"
#include "Logic/Registration/PoseEvaluation.h"

namespace falciform {

namespace {

/// What a job needs of the case, as it was when the job was made.
struct Snapshot {
  std::shared_ptr<const Surface> preop, scan;
  RegistrationSettings settings;
  IterationObserver observer;
  std::shared_ptr<PreparedOnce> once;

  [[nodiscard]] RegistrationResult run(const Isometry3d& start, const Progress& progress) const {
    progress.report(0, "preparing the surface");
    return registerSurfaces(*once->of(preop), *scan, settings, start, progress, observer);
  }
  [[nodiscard]] Snapshot fromGivenPose() const {
    Snapshot other = *this;
    other.settings.start = RegistrationStart::Given;
    if (settings.method == RegistrationMethod::Auto) other.settings.method = RegistrationMethod::Picp;
    return other;
  }
};

}  // namespace

std::string RegistrationLogic::missingSurfaces() const {
  if (!case_.preop()) return "Import or open the pre-operative surface first.";
  if (!case_.scan()) return "Open an intra-operative scan first.";
  return {};
}

std::string RegistrationLogic::missingLandmarks() const {
  if (case_.preopLandmarks().points.size() < 3 || case_.scanLandmarks().points.size() < 3)
    return "A landmark start needs at least 3 landmarks on both sides.";
  return pointRegistrationProblem(case_.preopLandmarks(), case_.scanLandmarks());
}

std::string RegistrationLogic::missingInput() const {
  if (std::string missing = missingSurfaces(); !missing.empty()) return missing;
  if (startFromLandmarks)
    if (std::string missing = missingLandmarks(); !missing.empty()) return missing;
  if (looksAtPatches(settings) && (patchLabels(*case_.preop()).empty() || patchLabels(*case_.scan()).empty()))
    return "Paint at least one patch on both the surface and the scan, or choose the method auto or icp.";
  return {};
}

std::optional<PointRegistrationResult> RegistrationLogic::landmarkFit() const {
  if (!missingLandmarks().empty()) return std::nullopt;
  return registerPoints(case_.preopLandmarks(), case_.scanLandmarks());
}

RegistrationLogic::Job RegistrationLogic::prepare() const {
  const Snapshot snapshot{case_.preop(), case_.scan(), settings, observer, prepared_};
  if (!startFromLandmarks)
    return [snapshot](const Progress& progress) { return snapshot.run(Isometry3d::Identity(), progress); };
  return [given = snapshot.fromGivenPose(), from = case_.preopLandmarks(),
          to = case_.scanLandmarks()](const Progress& progress) {
    const PointRegistrationResult fit = registerPoints(from, to);
    RegistrationResult result = given.run(fit.targetFromSource, progress);
    result.warnings.insert(result.warnings.begin(), fit.warnings.begin(), fit.warnings.end());
    return result;
  };
}

RegistrationLogic::Job RegistrationLogic::prepareFrom(const Isometry3d& start) const {
  const Snapshot snapshot{case_.preop(), case_.scan(), settings, observer, prepared_};
  return [given = snapshot.fromGivenPose(), start](const Progress& progress) {
    return given.run(start, progress);
  };
}

RegistrationLogic::Job RegistrationLogic::prepareEvaluation(RegistrationResult pose,
                                                            const Isometry3d& start) const {
  return [preop = case_.preop(), scan = case_.scan(), used = settings, pose = std::move(pose), start,
          once = prepared_](const Progress& progress) {
    progress.report(0, "figures of the pose");
    return evaluatePose(pose, *once->of(preop), *scan, used, start);
  };
}

void RegistrationLogic::accept(RegistrationResult result) {
  case_.setRegistration(std::make_shared<const RegistrationResult>(std::move(result)));
}

const RegistrationResult& RegistrationLogic::run(const Progress& progress) {
  if (const std::string missing = missingInput(); !missing.empty()) throw InputError(missing);
  accept(prepare()(progress));
  return *case_.registration();
}

RegistrationResult withBasin(const RegistrationResult& result, std::size_t chosen) {
  const RegistrationBasin basin = result.basins.at(chosen);
  RegistrationResult other = result;
  std::rotate(other.basins.begin(), other.basins.begin() + static_cast<std::ptrdiff_t>(chosen),
              other.basins.begin() + static_cast<std::ptrdiff_t>(chosen) + 1);
  if (chosen == 0) return other;
  char note[128];
  std::snprintf(
      note, sizeof note,
      "pose %zu of the list of basins, chosen by the user: its score is %.3f, that of the best %.3f",
      chosen + 1, basin.score, result.basins.front().score);
  other.scanFromPreop = basin.scanFromPreop;
  other.expectedTargetErrorMm = nullptr;
  other.expectedErrorMeanMm = 0;
  other.warp.reset();
  other.history.clear();
  other.iterations = 0;
  other.converged = false;
  other.stopReason = "chosen from the list of basins";
  other.warnings = {note};
  return other;
}

}  // namespace falciform
