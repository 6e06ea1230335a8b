#include "Modules/CommandLine/BuiltInCase.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"

namespace falciform::commandline {

namespace {

void declare(Syntax& syntax) {
  syntax.add({.name = "out",
              .kind = ArgumentKind::Folder,
              .label = "Case folder",
              .help = "Receives a case that `falciform run` takes: label map, painted surface, scan, "
                      "landmarks, structures, targets and truth.",
              .required = true,
              .output = true,
              .group = "Files"});
  syntax.addSettings(SyntheticLiverSettings{}, "Liver");
  syntax.addSettings(SyntheticDeformationSettings{}, "Change between CT and scan");
  syntax.rename("rms", "deformation");
  syntax.addSettings(TouchSettings{}, "Change between CT and scan");
  syntax.addSettings(VirtualScannerSettings{}, "Scanner");
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path folder = arguments.path("out"), sidecar = folder / "synthesise.json";
  for (const auto& file : builtInCaseFiles(folder)) run.outputs.announce(file);
  run.outputs.announce(sidecar);
  BuiltInCaseSettings settings;
  settings.liver = arguments.settings(settings.liver);
  settings.deformation = arguments.settings(settings.deformation);
  settings.touch = arguments.settings(settings.touch);
  settings.scanner = arguments.settings(settings.scanner);
  run.settings = {{"liver", settingsToJson(settings.liver)},
                  {"deformation", settingsToJson(settings.deformation)},
                  {"landmarks", settingsToJson(settings.touch)},
                  {"scanner", settingsToJson(settings.scanner)}};
  const BuiltInCase made = makeBuiltInCase(settings, run.progress.part(0, 0.9));
  run.frames = {{"labelmap.nii.gz, preop_painted.vtp, structures, targets", "patient LPS, mm"},
                {"scan.vtp, scan_landmarks, truth_targets", "scanner, mm"},
                {"truth_scan_from_preop.tfm", "maps pre-op LPS mm to scan mm"}};
  run.figures = {{"vertices", made.liver.surface.size()},
                 {"scan_points", made.scan.scan.size()},
                 {"coverage", made.scan.coverage}};
  run.progress.report(0.9, "Writing");
  writeBuiltInCase(made, folder, run.outputs);
  run.writeSidecar(sidecar);
  run.say("liver of " + std::to_string(made.liver.surface.size()) + " points, scan of " +
          std::to_string(made.scan.scan.size()) + " points that covers " +
          fixed(100 * made.scan.coverage, 1) + " %");
  run.say("written to " + folder.string() + "; falciform run " + folder.string() + " --out DIR registers it");
}

}  // namespace

Command synthesiseCommand() {
  return {"synthesise", "Synthetic case",
          "Makes a synthetic liver, its label map and a scan of it, with known truth.", declare, execute};
}

}  // namespace falciform::commandline
