#include "Modules/CommandLine/DistanceOutputs.h"

namespace falciform::commandline {

namespace {

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files";
  syntax.add({.name = "preop",
              .kind = Surface,
              .label = "Pre-operative surface",
              .help = "Triangles, LPS mm.",
              .required = true,
              .group = group});
  syntax.add({.name = "scan",
              .kind = Surface,
              .label = "Scan",
              .help = "Surface or point cloud, mm.",
              .required = true,
              .group = group});
  syntax.add({.name = "transform",
              .kind = Transform,
              .label = "Scan from pre-op",
              .help = "Maps pre-op mm to scan mm: .tfm, .txt or .json, as register writes it.",
              .required = true,
              .group = group});
  syntax.add({.name = "out",
              .kind = Folder,
              .label = "Result folder",
              .help = "Receives preop_distance.vtp, scan_distance.vtp, distance.csv and distance.json.",
              .required = true,
              .output = true,
              .group = group});
  syntax.addSettings(DistanceSettings{}, "Coverage");
  syntax.addResult({"coverage", "Covered share of the pre-op surface", ""});
  syntax.addResult({"mean_mm", "Mean signed distance", "mm"});
  syntax.addResult({"rms_mm", "RMS distance", "mm"});
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path folder = arguments.path("out");
  for (const std::string& name : distanceFiles()) run.outputs.announce(folder / name);
  run.outputs.announce(folder / "distance.json");
  const auto settings = arguments.settings(DistanceSettings{});
  run.settings["distance"] = settingsToJson(settings);

  run.progress.report(0, "Reading");
  const falciform::Surface preop = run.mesh(arguments.path("preop")),
                           scan = run.surface(arguments.path("scan"));
  const Isometry3d scanFromPreop = run.transform(arguments.path("transform"));
  const DistanceMap map = mapDistances(preop, scan, scanFromPreop, settings, run.progress.part(0.1, 0.9));
  if (map.preopAll.count == 0)
    run.warn("the scan covers no part of the pre-op surface; check the transform and the reach");
  run.figures = distanceFigures(map);
  run.progress.report(0.9, "Writing");
  writeDistance(map, folder, run);
  run.writeSidecar(folder / "distance.json");
  tellDistance(map, run);
  run.say("written to " + folder.string());
}

}  // namespace

Command distanceCommand() {
  return {"distance", "Distance map",
          "Maps the signed distance between a registered scan and the pre-operative surface.", declare,
          execute};
}

}  // namespace falciform::commandline
