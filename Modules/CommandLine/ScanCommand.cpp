#include "Logic/Acquisition/ScanGraph.h"
#include "Logic/Acquisition/ScanPreparation.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/IO/DepthFrames.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/PictureTiles.h"
#include "Modules/CommandLine/ScanPicture.h"
#include "Modules/CommandLine/SeedInput.h"

namespace falciform::commandline {

namespace {

namespace fs = std::filesystem;

constexpr char kMarkArray[] = "scan_mark";

void declareFiles(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files";
  syntax.add({.name = "IN",
              .kind = Surface,
              .label = "Raw scan",
              .help =
                  "PLY, OBJ, VTK, VTP with colours or texture, PCD, XYZ or CSV (rasters too), .rgbd, or a "
                  "16-bit .png of depths.",
              .required = true,
              .positional = true,
              .group = group});
  syntax.add({.name = "out",
              .kind = Surface,
              .label = "Prepared scan",
              .help = "Surface to write: .vtp, .ply, .obj, .vtk; its texture is written beside it as "
                      "NAME_texture.png, its sidecar as FILE.json.",
              .required = true,
              .output = true,
              .group = group});
  syntax.add({.name = "marked",
              .kind = Surface,
              .label = "Marked scan",
              .help =
                  "Also write the whole scan in mm with an array 'scan_mark': 0 kept, 1 outlier, 2 grazing, "
                  "3 small piece, 4 other tissue.",
              .output = true,
              .group = group});
  syntax.add({.name = "picture",
              .kind = File,
              .label = "Picture",
              .help = "Also write scan, marks and result side by side, .png.",
              .output = true,
              .group = group});
  const std::string depth = "Depth frames";
  syntax.add({.name = "camera",
              .kind = File,
              .label = "Camera",
              .help = "Intrinsics of a depth frame, .json or text; by default the file beside it.",
              .group = depth});
  syntax.add({.name = "colours",
              .kind = File,
              .label = "Photograph",
              .help = "Of the same view, .png or .jpg; by default the file beside it.",
              .group = depth});
  syntax.add({.name = "pose",
              .kind = File,
              .label = "Camera pose",
              .help =
                  "Tracker from camera, mm: .tfm, 4x4 text, .json or a tracker's .xml; by default the file "
                  "beside it.",
              .group = depth});
}

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  declareFiles(syntax);
  const std::string group = "Where things are";
  declareSeeds(
      syntax, group,
      "Places on the liver, in the scan's frame and mm; each brings in its own colour, and without any "
      "the liver is found by its colour");
  syntax.add({.name = "scanner-at",
              .kind = Text,
              .label = "Scanner",
              .help =
                  "Where the scanner stood, in the scan's frame and mm: x,y,z; by default on the side that "
                  "the scan faces.",
              .group = group});
  syntax.addSettings(ScanPreparationSettings{}, "Preparation");
  syntax.addResult({"points_read", "Points read", ""});
  syntax.addResult({"points_written", "Points written", ""});
  syntax.addResult({"area_mm2", "Area", "mm2"});
}

falciform::Surface readScan(const ParsedArguments& arguments, CommandRun& run) {
  const fs::path file = arguments.path("IN");
  const bool given = arguments.has("camera") || arguments.has("colours") || arguments.has("pose");
  if (!isDepthFrame(file)) {
    if (given)
      throw InputError(file.filename().string() +
                       " is no depth frame; --camera, --colours and --pose go with .rgbd and 16-bit .png");
    return run.surface(file);
  }
  DepthFrameFiles files =
      depthFrameBeside(file, arguments.has("camera") ? arguments.path("camera") : fs::path());
  if (arguments.has("colours")) files.colour = arguments.path("colours");
  if (arguments.has("pose")) files.pose = arguments.path("pose");
  for (const fs::path& other : {files.depth, files.colour, files.camera, files.pose})
    if (!other.empty()) run.remember(other);
  Loaded<falciform::Surface> scan = readSurface(files);
  run.warn(scan.warnings);
  return std::move(scan.value);
}

nlohmann::json figuresOf(const MarkedScan& marked, const falciform::Surface& prepared) {
  nlohmann::json seeds = nlohmann::json::array();
  for (const int seed : marked.seeds)
    seeds.push_back({marked.scan.points(seed, 0), marked.scan.points(seed, 1), marked.scan.points(seed, 2)});
  return {{"points_read", marked.scan.size()},
          {"unit_factor", marked.factor},
          {"outliers", marked.count(ScanMark::Outlier)},
          {"grazing", marked.count(ScanMark::Grazing)},
          {"small_pieces", marked.count(ScanMark::SmallPiece)},
          {"other_tissue", marked.count(ScanMark::OtherTissue)},
          {"kept", marked.count(ScanMark::Kept)},
          {"points_written", prepared.size()},
          {"triangles_written", prepared.triangles.rows()},
          {"area_mm2", prepared.triangles.rows() > 0 ? area(prepared) : 0.0},
          {"spacing_mm", usualSpacing(prepared, scanNeighbours(prepared))},
          {"seeds_mm", seeds},
          {"seed_found_by_itself", marked.automatic},
          {"by_colour", marked.byColour},
          {"colours", prepared.texture              ? "texture"
                      : prepared.colours.rows() > 0 ? "points"
                                                    : "none"}};
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const fs::path out = arguments.path("out"), marks = arguments.path("marked"),
                 picture = picturePath(arguments);
  for (const fs::path& surface : {out, marks}) {
    if (surface.empty()) continue;
    run.outputs.announce(surface);
    for (const fs::path& beside : filesBeside(surface)) run.outputs.announce(beside);
  }
  run.outputs.announce(sidecarOf(out));
  if (!picture.empty()) run.outputs.announce(picture);
  const auto settings = arguments.settings(ScanPreparationSettings{});
  run.settings["scan"] = settingsToJson(settings);
  const falciform::Points seeds = seedsOf(arguments, run);
  std::optional<Vector3d> scannerAt;
  if (arguments.has("scanner-at")) scannerAt = placeOf(arguments, "scanner-at");

  run.progress.report(0, "Reading the scan");
  const falciform::Surface raw = readScan(arguments, run);
  run.frames = {{out.filename().string(), raw.frame + ", mm; as the scan"}};
  const MarkedScan marked = markScan(raw, seeds, scannerAt, settings, run.progress.part(0.1, 0.7));
  run.warn(marked.warnings);
  const falciform::Surface prepared = finishScan(marked, settings, run.progress.part(0.7, 0.9));
  run.figures = figuresOf(marked, prepared);
  run.progress.report(0.9, "Writing");
  writeSurface(run.outputs.staged(out), prepared, Overwrite::Replace);
  if (!marks.empty()) {
    falciform::Surface whole = marked.scan;
    VectorXd& values = whole.arrays[kMarkArray];
    values.resize(whole.size());
    for (Index i = 0; i < whole.size(); ++i)
      values[i] = static_cast<double>(marked.marks[static_cast<std::size_t>(i)]);
    writeSurface(run.outputs.staged(marks), whole, Overwrite::Replace);
  }
  if (!picture.empty())
    savePng(scanPicture(marked, prepared), run.outputs.staged(picture), Overwrite::Replace);
  run.writeSidecar(sidecarOf(out));
  std::string line =
      out.string() + ": " + std::to_string(prepared.size()) + " of " + std::to_string(raw.size()) + " points";
  for (const ScanMark mark :
       {ScanMark::Outlier, ScanMark::Grazing, ScanMark::SmallPiece, ScanMark::OtherTissue})
    line += ", " + std::to_string(marked.count(mark)) + " " + enumToString(mark);
  run.say(line + "; " + fixed(run.figures["area_mm2"].get<double>() / 100, 1) + " cm2");
}

}  // namespace

Command scanCommand() {
  return {"scan", "Prepare scan", "Cleans a raw range scan and cuts it down to the liver.", declare, execute};
}

}  // namespace falciform::commandline
