#include "Modules/CommandLine/StartPose.h"

#include <cstdio>

#include "Logic/Registration/PointRegistration.h"

namespace falciform::commandline {

namespace {

StartPose fromLandmarks(const Landmarks& preop, const Landmarks& scan, CommandRun& run) {
  if (preop.points.empty() || scan.points.empty())
    throw InputError("the start is 'landmarks' and there are " + std::to_string(preop.points.size()) +
                     " pre-op and " + std::to_string(scan.points.size()) +
                     " scan landmarks; give both lists, at least 3 points each");
  const PointRegistrationResult fit = registerPoints(preop, scan);
  run.warn(fit.warnings);
  run.figures["landmark_fre_mm"] = fit.freMm;
  char words[96];
  std::snprintf(words, sizeof words, "landmarks (%zu points, fiducial registration error %.2f mm)",
                preop.points.size(), fit.freMm);
  return {fit.targetFromSource, words, "the landmark fit"};
}

}  // namespace

StartPose resolveStart(const std::string& init, RegistrationSettings& settings,
                       const Landmarks& preopLandmarks, const Landmarks& scanLandmarks, CommandRun& run) {
  if (init.empty()) {
    if (settings.start == RegistrationStart::Patches && settings.method != RegistrationMethod::Icp)
      return {Isometry3d::Identity(), "several poses from the patches, the best kept"};
    settings.start = RegistrationStart::Given;
    return {Isometry3d::Identity(), "the pose as stored (identity)"};
  }
  settings.start = RegistrationStart::Given;
  if (init == "identity") return {Isometry3d::Identity(), "the pose as stored (identity)"};
  if (init == "landmarks") return fromLandmarks(preopLandmarks, scanLandmarks, run);
  return {run.transform(init), "the transform " + std::filesystem::path(init).filename().string(),
          "the given start"};
}

}  // namespace falciform::commandline
