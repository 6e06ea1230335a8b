#include "Modules/CommandLine/RegistrationOutputs.h"

#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Modules/CommandLine/Figures.h"

namespace falciform::commandline {

void declareStart(Syntax& syntax, const std::string& group) {
  using enum ArgumentKind;
  syntax.add({.name = "init",
              .kind = Text,
              .label = "Initial pose",
              .help = "identity, landmarks, or a transform file (.tfm, .txt, .json) that maps pre-op mm to "
                      "scan mm; makes the start 'given'. "
                      "Without it the patches give the start, and icp starts from the pose as stored.",
              .group = group});
  syntax.add({.name = "preop-landmarks",
              .kind = Points,
              .label = "Pre-op landmarks",
              .help = "Used by --init landmarks; LPS mm.",
              .group = group});
  syntax.add({.name = "scan-landmarks",
              .kind = Points,
              .label = "Scan landmarks",
              .help = "Used by --init landmarks; scan mm.",
              .group = group});
}

void declarePreset(Syntax& syntax, const std::string& group) {
  syntax.add({.name = "preset",
              .kind = ArgumentKind::Choice,
              .label = "Preset",
              .help = "Values for all that follows; what is given beside it wins.",
              .fallback = "default",
              .choices = registrationPresets(),
              .group = group});
}

StartPose startOf(const ParsedArguments& arguments, RegistrationSettings& settings,
                  const Landmarks& preopLandmarks, const Landmarks& scanLandmarks, CommandRun& run) {
  const std::string init = arguments.text("init");
  if (!init.empty() && arguments.has("start") && settings.start == RegistrationStart::Patches)
    throw InputError("--init gives the start and --start is patches; leave one of them out");
  if (init != "landmarks" && (arguments.has("preop-landmarks") || arguments.has("scan-landmarks")))
    run.warn("the landmarks are not used; --init landmarks starts from them");
  return resolveStart(init, settings, preopLandmarks, scanLandmarks, run);
}

std::vector<std::string> poseFiles() {
  return {"scan_from_preop.tfm", "scan_from_preop.txt", "scan_from_preop.json"};
}

std::vector<std::string> registrationFiles() {
  std::vector<std::string> files = poseFiles();
  files.emplace_back("preop_on_scan.vtp");
  return files;
}

void writePose(const Isometry3d& scanFromPreop, const std::filesystem::path& folder, CommandRun& run) {
  for (const std::string& name : poseFiles())
    writeTransform(run.outputs.staged(folder / name), scanFromPreop, kScanFromPreopInWords,
                   Overwrite::Replace);
}

void writeRegistration(const Surface& preop, const Surface& scan, const RegistrationResult& result,
                       const std::filesystem::path& folder, CommandRun& run) {
  writePose(result.scanFromPreop, folder, run);
  Surface moved = transformed(preop, result.scanFromPreop, scan.frame);
  if (result.warp) {
    moved.points = result.warp->preopOnScan;
    moved.normals.resize(0, 3);  // turned by the rigid part alone, they would be wrong
  }
  writeSurface(run.outputs.staged(folder / "preop_on_scan.vtp"), moved, Overwrite::Replace);
}

void describeFrames(CommandRun& run) {
  run.frames["scan_from_preop"] = kScanFromPreopInWords;
  run.frames["preop_on_scan.vtp"] = "the pre-op surface moved into the scan's frame, mm";
}

void tellRegistration(const RegistrationResult& result, const StartPose& start, CommandRun& run) {
  run.say("fit (not target error): RMS " + fixed(result.rmsMm, 3) + " mm, mean " + fixed(result.meanMm, 3) +
          " mm, P95 " + fixed(result.p95Mm, 3) + " mm over " + std::to_string(result.scanPoints) +
          " scan points");
  run.say("coverage " + fixed(100 * result.coverage, 1) + " %, rotation " + fixed(result.rotationDeg, 2) +
          " deg, translation " + fixed(result.translationMm, 2) + " mm against " + start.reference + "; " +
          std::to_string(result.iterations) + " iterations, " + std::to_string(result.basins.size()) +
          (result.basins.size() == 1 ? " basin; " : " basins; ") + result.stopReason);
  if (result.expectedErrorMeanMm > 0)
    run.say("expected target error of the rigid pose: " + fixed(result.expectedErrorMeanMm, 1) +
            " mm (root mean square over the liver, bending included)");
  run.say("start: " + start.words);
}

}  // namespace falciform::commandline
