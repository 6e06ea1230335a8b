#include "Logic/Core/Errors.h"
#include "Logic/Deformation/SegmentLabels.h"
#include "Modules/CommandLine/DistanceOutputs.h"
#include "Modules/CommandLine/DistancePicture.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/PictureTiles.h"

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
  syntax.add(
      {.name = "segments",
       .kind = LabelMap,
       .label = "Couinaud segments",
       .help = "Segment map of the pre-op CT, labels 1 to 8: figures of each segment as well. Without it, an "
               "array couinaud_segment of the pre-op surface is taken if there is one.",
       .group = group});
  syntax.add({.name = "segment-reach",
              .kind = Number,
              .label = "Segment reach",
              .unit = "mm",
              .help = "A vertex is of the segment of the nearest labelled voxel within this.",
              .fallback = "5",
              .min = 0.1,
              .max = 50,
              .group = "Coverage"});
  syntax.add({.name = "out",
              .kind = Folder,
              .label = "Result folder",
              .help = "Receives preop_distance.vtp, scan_distance.vtp, distance.csv and distance.json.",
              .required = true,
              .output = true,
              .group = group});
  syntax.add({.name = "picture",
              .kind = File,
              .label = "Picture",
              .help = "Also draw distance, curvature difference and segments on the pre-op surface, .png.",
              .output = true,
              .group = group});
  syntax.addSettings(DistanceSettings{}, "Coverage");
  syntax.addResult({"coverage", "Covered share of the pre-op surface", ""});
  syntax.addResult({"mean_mm", "Mean signed distance", "mm"});
  syntax.addResult({"rms_mm", "RMS distance", "mm"});
}

/// The segment of every vertex, as an array.
void addSegments(falciform::Surface& preop, const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path file = arguments.path("segments");
  const double reach = parseNumber("--segment-reach", arguments.text("segment-reach"));
  VectorXd found = labelsAtPoints(preop.points, run.labelMap(file), reach);
  const Index with = (found.array() > 0).count();
  if (with == 0)
    throw InputError("no vertex of the pre-op surface lies within " + numberText(reach) +
                     " mm of a labelled voxel of " + file.filename().string() +
                     "; give the segment map of the same CT");
  if (with < preop.size() / 2)
    run.warn("only " + fixed(100.0 * static_cast<double>(with) / static_cast<double>(preop.size()), 0) +
             " % of the pre-op vertices lie within " + numberText(reach) +
             " mm of a segment; check that the map is of the same liver");
  run.settings["segments"] = {{"reach_mm", reach}, {"vertices_in_a_segment", with}};
  preop.arrays[kCouinaudSegment] = std::move(found);
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path folder = arguments.path("out");
  for (const std::string& name : distanceFiles()) run.outputs.announce(folder / name);
  run.outputs.announce(folder / "distance.json");
  const std::filesystem::path picture = picturePath(arguments);
  if (!picture.empty()) run.outputs.announce(picture);
  const auto settings = arguments.settings(DistanceSettings{});
  run.settings["distance"] = settingsToJson(settings);

  run.progress.report(0, "Reading");
  falciform::Surface preop = run.mesh(arguments.path("preop"));
  const falciform::Surface scan = run.surface(arguments.path("scan"));
  if (arguments.has("segments")) addSegments(preop, arguments, run);
  const Isometry3d scanFromPreop = run.transform(arguments.path("transform"));
  const DistanceMap map = mapDistances(preop, scan, scanFromPreop, settings, run.progress.part(0.1, 0.9));
  if (map.preopAll.count == 0)
    run.warn("the scan covers no part of the pre-op surface; check the transform and the reach");
  run.figures = distanceFigures(map);
  run.progress.report(0.9, "Writing");
  writeDistance(map, folder, run);
  if (!picture.empty())
    saveDistanceSheet(map, scanFromPreop, run.outputs.staged(picture), Overwrite::Replace);
  run.writeSidecar(folder / "distance.json");
  tellDistance(map, run);
  run.say("written to " + folder.string());
}

}  // namespace

Command distanceCommand() {
  return {"distance", "Distance map",
          "Maps signed distance and curvature difference between a registered scan and the pre-op surface.",
          declare, execute};
}

}  // namespace falciform::commandline
