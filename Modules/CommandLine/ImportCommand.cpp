#include "Logic/IO/SurfaceFiles.h"
#include "Logic/Segmentation/SurfaceImport.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"

namespace falciform::commandline {

namespace {

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files";
  syntax.add({.name = "LABELMAP",
              .kind = LabelMap,
              .label = "Label map",
              .help = "NIfTI, NRRD (.seg.nrrd too), MetaImage, or a DICOM folder: masks or DICOM SEG.",
              .required = true,
              .positional = true,
              .group = group});
  declareSeries(syntax, group, "of the label map");
  syntax.add({.name = "out",
              .kind = Surface,
              .label = "Surface",
              .help = "Surface to write: .vtp, .vtk, .stl, .ply or .obj, LPS mm; its sidecar is written "
                      "beside it as FILE.json.",
              .required = true,
              .output = true,
              .group = group});
  syntax.addSettings(SurfaceImportSettings{}, "Surface");
  syntax.rename("labels", "label");
  syntax.addResult({"surface_volume_mm3", "Enclosed volume", "mm3"});
  syntax.addResult({"mean_edge_mm", "Mean edge length", "mm"});
  syntax.addResult({"mean_distance_to_mask_mm", "Mean distance to the mask", "mm"});
  syntax.addResult({"p95_distance_to_mask_mm", "95 % of the distances to the mask", "mm"});
  syntax.addResult({"max_distance_to_mask_mm", "Largest distance to the mask", "mm"});
  syntax.addResult({"self_crossings", "Triangles that cut through each other", "pairs"});
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path out = arguments.path("out");
  run.outputs.announce(out);
  run.outputs.announce(sidecarOf(out));
  const auto settings = arguments.settings(SurfaceImportSettings{});
  run.settings["import"] = settingsToJson(settings);
  run.frames = {{out.filename().string(), "patient LPS, mm"}};

  run.progress.report(0, "Reading the label map");
  const NamedLabels labels = run.namedLabels(arguments.path("LABELMAP"), arguments.text("series"));
  const SurfaceImportResult result = importSurface(labels.map, settings, run.progress.part(0.1, 0.95));
  run.warn(result.warnings);
  run.figures = toJson(result);
  for (const auto& [label, name] : labels.names) {
    run.figures["label_names"][std::to_string(label)] = name;
    run.say("label " + std::to_string(label) + ": " + name);
  }
  run.progress.report(0.95, "Writing");
  writeSurface(run.outputs.staged(out), result.surface, Overwrite::Replace);
  run.writeSidecar(sidecarOf(out));
  run.say(out.string() + ": " + std::to_string(result.surface.size()) + " points, " +
          describeTopology(result.topology) + ", " + fixed(result.surfaceVolumeMm3 / 1000, 1) +
          " ml, mean edge " + fixed(result.quality.meanEdgeMm, 2) + " mm, from the mask " +
          fixed(result.quality.meanMm, 2) + " mm on average, 95 % within " + fixed(result.quality.p95Mm, 2) +
          ", at most " + fixed(result.quality.maxMm, 2) + " mm, " + std::to_string(result.quality.crossings) +
          " self-crossings");
}

}  // namespace

Command importCommand() {
  return {"import", "Import segmentation", "Turns a label map into a closed surface of the liver.", declare,
          execute};
}

}  // namespace falciform::commandline
