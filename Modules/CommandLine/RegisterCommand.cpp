#include "Logic/IO/ResultFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Logic/Patches/PatchStatistics.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/RegistrationOutputs.h"
#include "Modules/CommandLine/StartPose.h"
#include "Modules/CommandLine/TargetError.h"

namespace falciform::commandline {

namespace {

void declareFiles(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files";
  syntax.add({.name = "preop",
              .kind = Surface,
              .label = "Pre-operative surface",
              .help = "LPS mm, with a Patch array for wgf and picp.",
              .required = true,
              .group = group});
  syntax.add({.name = "scan",
              .kind = Surface,
              .label = "Scan",
              .help = "Surface or point cloud in the scanner's frame, mm.",
              .required = true,
              .group = group});
  syntax.add({.name = "out",
              .kind = Folder,
              .label = "Result folder",
              .help = "Receives scan_from_preop.tfm, .txt and .json, preop_on_scan.vtp and register.json.",
              .required = true,
              .output = true,
              .group = group});
  syntax.add({.name = "targets",
              .kind = Points,
              .label = "Targets",
              .help = "Points inside the liver, pre-op LPS mm, to measure target error.",
              .group = group});
  syntax.add({.name = "truth-targets",
              .kind = Points,
              .label = "True targets",
              .help = "Where the targets truly are, scan mm.",
              .group = group});
  syntax.add({.name = "transform-out",
              .kind = Transform,
              .label = "Transform",
              .help = "Also write the transform, pre-op to scan, here.",
              .output = true,
              .group = group});
}

void declare(Syntax& syntax) {
  declareFiles(syntax);
  declareStart(syntax, "Start");
  declarePreset(syntax, "Method");
  syntax.addSettings(RegistrationSettings{}, "Method");
  syntax.addResult({"rms_mm", "RMS residual (fit, not target error)", "mm"});
  syntax.addResult({"coverage", "Covered share of the pre-op surface", ""});
  syntax.addResult({"rotation_deg", "Rotation from the start", "deg"});
  syntax.addResult({"translation_mm", "Translation from the start", "mm"});
  syntax.addResult({"target_error_mean_mm", "Mean target error", "mm"});
}

Landmarks optionalLandmarks(const ParsedArguments& arguments, const std::string& name, CommandRun& run) {
  return arguments.has(name) ? run.landmarks(arguments.path(name)) : Landmarks{};
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path folder = arguments.path("out"), sidecar = folder / "register.json";
  for (const auto& name : registrationFiles()) run.outputs.announce(folder / name);
  run.outputs.announce(sidecar);
  if (arguments.has("transform-out")) run.outputs.announce(arguments.path("transform-out"));
  if (arguments.has("targets") != arguments.has("truth-targets"))
    throw InputError("--targets and --truth-targets belong together; give both or none");

  run.progress.report(0, "Reading");
  const falciform::Surface preop = run.mesh(arguments.path("preop")),
                           scan = run.surface(arguments.path("scan"));
  const Landmarks targets = optionalLandmarks(arguments, "targets", run),
                  truth = optionalLandmarks(arguments, "truth-targets", run);
  RegistrationSettings settings = arguments.settings(registrationPreset(arguments.text("preset")));
  const StartPose start = startOf(arguments, settings, optionalLandmarks(arguments, "preop-landmarks", run),
                                  optionalLandmarks(arguments, "scan-landmarks", run), run);
  run.settings["registration"] = settingsToJson(settings);
  run.settings["preset"] = arguments.text("preset");
  if (looksAtPatches(settings)) run.warn(patchWarnings(preop, scan));

  const RegistrationResult result =
      registerSurfaces(preop, scan, settings, start.scanFromPreop, run.progress.part(0.05, 0.95));
  run.warn(result.warnings);
  run.figures.update(toJson(result));
  run.figures["start"] = start.words;
  if (!targets.points.empty()) {
    const TargetError error = measureTargetError(targets, truth, result, start.scanFromPreop);
    run.figures["target_error"] = toJson(error);
    run.figures["target_error_mean_mm"] = error.meanMm;
  }
  describeFrames(run);
  run.progress.report(0.95, "Writing");
  writeRegistration(preop, scan, result, folder, run);
  if (arguments.has("transform-out"))
    writeTransform(run.outputs.staged(arguments.path("transform-out")), result.scanFromPreop,
                   kScanFromPreopInWords, Overwrite::Replace);
  run.writeSidecar(sidecar);
  tellRegistration(result, start, run);
  if (run.figures.contains("target_error_mean_mm"))
    run.say("target error: mean " + fixed(run.figures["target_error_mean_mm"], 2) + " mm, largest " +
            fixed(run.figures["target_error"]["max_mm"], 2) + " mm");
  run.say("written to " + folder.string());
}

}  // namespace

Command registerCommand() {
  return {"register", "Register scan",
          "Finds where an intra-operative scan lies on the pre-operative surface (rigid).", declare, execute};
}

}  // namespace falciform::commandline
