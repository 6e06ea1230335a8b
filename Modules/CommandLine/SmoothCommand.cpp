#include "Logic/Acquisition/ScanFacing.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/RbfSurface.h"
#include "Logic/Geometry/ScannerSide.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/SmoothPicture.h"

namespace falciform::commandline {

namespace {

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files";
  syntax.add({.name = "SURFACE",
              .kind = Surface,
              .label = "Surface or scan",
              .help = "Triangles, or points with or without normals: .vtp, .vtk, .stl, .ply or .obj.",
              .required = true,
              .positional = true,
              .group = group});
  syntax.add({.name = "out",
              .kind = Surface,
              .label = "Smooth surface",
              .help =
                  "Surface to write: .vtp, .vtk, .stl, .ply or .obj, in the frame of the input; only .vtp "
                  "keeps the curvature. Its sidecar is written beside it as FILE.json.",
              .required = true,
              .output = true,
              .group = group});
  syntax.add({.name = "picture",
              .kind = File,
              .label = "Picture",
              .help = "Also write both surfaces coloured by their mean curvature, .png.",
              .output = true,
              .group = group});
  syntax.addSettings(RbfSurfaceSettings{}, "Radial basis functions");
  syntax.addResult({"noise_mm", "Noise", "mm"});
  syntax.addResult({"rms_mm", "RMS distance of the points", "mm"});
  syntax.addResult({"mean_edge_mm", "Mean edge length", "mm"});
}

nlohmann::json figuresOf(const RbfSurfaceResult& result) {
  nlohmann::json figures{{"noise_mm", result.fit.noiseMm},
                         {"spacing_mm", result.fit.spacingMm},
                         {"rms_mm", result.rmsMm},
                         {"largest_distance_mm", result.largestMm},
                         {"points", result.surface.size()},
                         {"points_in_filled_gaps", result.filledPoints},
                         {"mean_edge_mm", meanEdgeLength(result.surface)},
                         {"levels", nlohmann::json::array()}};
  for (const RbfLevelReport& level : result.fit.levels)
    figures["levels"].push_back(
        {{"step_mm", level.stepMm}, {"functions", level.functions}, {"rms_mm", level.rmsMm}});
  return figures;
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path out = arguments.path("out"), picture = picturePath(arguments);
  if (!picture.empty()) run.outputs.announce(picture);
  run.outputs.announce(out);
  run.outputs.announce(sidecarOf(out));
  const auto settings = arguments.settings(RbfSurfaceSettings{});
  run.settings["smooth"] = settingsToJson(settings);

  run.progress.report(0, "Reading the surface");
  falciform::Surface surface = run.surface(arguments.path("SURFACE"));
  run.frames = {{out.filename().string(), surface.frame + ", mm"}};
  if (surface.triangles.rows() == 0 && surface.normals.rows() == 0) {
    giveNormals(surface, seenFrom(surface));
    run.warn(
        "the points have neither triangles nor normals: they are taken for a scan that bulges towards its "
        "scanner");
  }
  const RbfSurfaceResult result = smoothByRbf(surface, settings, run.progress.part(0.05, 0.95));
  run.warn(result.warnings);
  run.figures = figuresOf(result);
  run.progress.report(0.95, "Writing");
  writeSurface(run.outputs.staged(out), result.surface, Overwrite::Replace);
  if (!picture.empty())
    savePng(smoothPicture(surface, result.surface), run.outputs.staged(picture), Overwrite::Replace);
  run.writeSidecar(sidecarOf(out));
  run.say(out.string() + ": " + std::to_string(result.surface.size()) + " points, " +
          describeTopology(inspectTopology(result.surface)) + ", mean edge " +
          fixed(meanEdgeLength(result.surface), 2) + " mm; noise " + fixed(result.fit.noiseMm, 2) +
          " mm, the points lie " + fixed(result.rmsMm, 2) + " mm RMS from it, " + fixed(result.largestMm, 1) +
          " mm at most");
}

}  // namespace

Command smoothCommand() {
  return {"smooth", "Smooth surface", "Smooths a surface or scan by radial basis functions, evenly sampled.",
          declare, execute};
}

}  // namespace falciform::commandline
