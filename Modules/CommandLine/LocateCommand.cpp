#include <cmath>
#include <numbers>

#include "Logic/Acquisition/Phantom.h"
#include "Logic/Acquisition/RegionCentroid.h"
#include "Logic/Core/LandmarkPairs.h"
#include "Logic/IO/DicomSeries.h"
#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/SeedInput.h"

namespace falciform::commandline {

namespace {

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string files = "Files", ct = "In a CT", scan = "In a scan";
  syntax.add(
      {.name = "INPUT",
       .kind = File,
       .label = "CT or scan",
       .help = "A CT (NIfTI, NRRD, MetaImage, DICOM folder) or a scan (VTP, VTK, PLY, STL, OBJ, XYZ, CSV).",
       .required = true,
       .positional = true,
       .group = files});
  declareSeries(syntax, files, "that is the CT");
  declareSeeds(syntax, files, "Clicks on or near the markers, mm in the frame of CT (LPS) or scan");
  syntax.add({.name = "out",
              .kind = Points,
              .label = "Located",
              .help = "The markers' centres, .mrk.json; its sidecar is written beside it as FILE.json.",
              .required = true,
              .output = true,
              .group = files});
  syntax.add({.name = "truth",
              .kind = Points,
              .label = "True places",
              .help = "Where they truly are, .mrk.json or .fcsv: each is compared with the nearest found.",
              .group = files});
  syntax.add(
      {.name = "threshold",
       .kind = Number,
       .label = "Threshold",
       .unit = "HU",
       .help = "A marker is joined voxels of at least this: half-way between marker and what it lies in.",
       .min = -5000,
       .max = 50000,
       .group = ct});
  syntax.add({.name = "all",
              .kind = Flag,
              .label = "All",
              .help =
                  "Find them without clicks: all that are at least --threshold and between --smallest and "
                  "--largest.",
              .group = ct});
  for (const auto& [name, label, fallback] :
       {std::tuple("smallest", "Smallest", "0.5"), std::tuple("largest", "Largest", "40")})
    syntax.add({.name = name,
                .kind = Number,
                .label = label,
                .unit = "mm",
                .help = "Diameter of a ball with as many voxels at or above the threshold.",
                .fallback = fallback,
                .min = 0,
                .max = 500,
                .group = ct});
  syntax.add({.name = "radius",
              .kind = Number,
              .label = "Radius",
              .unit = "mm",
              .help = "Of the spheres in a scan, known from their maker.",
              .min = 1,
              .max = 100,
              .group = scan});
  syntax.addResult({"found", "Found", ""});
}

double ballMm3(double diameterMm) { return std::numbers::pi / 6 * diameterMm * diameterMm * diameterMm; }

nlohmann::json rowOf(const Landmark& point) {
  return {{"name", point.name}, {"place_mm", {point.position.x(), point.position.y(), point.position.z()}}};
}

/// One located marker a click; the message of a click that fails says which.
template <class Locate>
Landmarks locateEach(const Landmarks& clicks, const std::string& frame, const Locate& locate) {
  Landmarks found;
  found.frame = frame;
  for (const Landmark& click : clicks.points) {
    try {
      found.points.push_back({click.name, locate(click)});
    } catch (const InputError& error) {
      throw InputError("'" + click.name + "': " + error.what());
    }
  }
  return found;
}

void addBody(const GrownRegion& body, const std::string& name, CommandRun& run) {
  nlohmann::json row = rowOf({name, body.centre});
  row["voxels"] = body.voxels;
  row["volume_mm3"] = body.volumeMm3;
  run.figures["markers"].push_back(row);
}

Landmarks inCt(const ParsedArguments& arguments, const Landmarks& clicks, CommandRun& run) {
  if (!arguments.has("threshold"))
    throw InputError(
        "--threshold is missing; give the value half-way between marker and what it lies in, e.g. "
        "-25 for Teflon in air, 1200 for steel in silicone");
  const double threshold = parseNumber("--threshold", arguments.text("threshold")),
               largest = ballMm3(parseNumber("--largest", arguments.text("largest")));
  const Image ct = run.image(arguments.path("INPUT"), arguments.text("series"));
  if (!arguments.has("all"))
    return locateEach(clicks, "LPS", [&](const Landmark& click) {
      const GrownRegion body = growRegion(ct, click.position, threshold, largest);
      addBody(body, click.name, run);
      return body.centre;
    });
  Landmarks found;
  for (const GrownRegion& body :
       findBodies(ct, threshold, ballMm3(parseNumber("--smallest", arguments.text("smallest"))), largest)) {
    found.points.push_back({"marker " + std::to_string(found.points.size() + 1), body.centre});
    addBody(body, found.points.back().name, run);
  }
  if (found.points.empty())
    throw InputError("nothing between " + arguments.text("smallest") + " and " + arguments.text("largest") +
                     " mm is at least " + arguments.text("threshold") +
                     " HU; change --threshold or the sizes");
  return found;
}

Landmarks inScan(const ParsedArguments& arguments, const Landmarks& clicks, CommandRun& run) {
  for (const char* of : {"threshold", "all"})
    if (arguments.has(of)) throw InputError(std::string("--") + of + " is for a CT; leave it out for a scan");
  if (!arguments.has("radius"))
    throw InputError("--radius is missing; give the spheres' radius in mm, as their maker states it");
  const falciform::Surface scan = run.surface(arguments.path("INPUT"));
  return locateEach(clicks, scan.frame, [&](const Landmark& click) {
    const Vector3d centre =
        locateSphere(scan.points, click.position, parseNumber("--radius", arguments.text("radius")));
    run.figures["markers"].push_back(rowOf({click.name, centre}));
    return centre;
  });
}

void compare(const Landmarks& found, const Landmarks& truth, CommandRun& run) {
  const falciform::Points there = positionsOf(found);
  if (truth.points.empty()) throw InputError("--truth holds no point; give the true places");
  double worst = 0, sum = 0;
  for (const Landmark& point : truth.points) {
    const double error = (there.rowwise() - point.position.transpose()).rowwise().norm().minCoeff();
    run.figures["truth"].push_back({{"name", point.name}, {"error_mm", error}});
    worst = std::max(worst, error);
    sum += error / static_cast<double>(truth.points.size());
  }
  run.figures["error_mean_mm"] = sum;
  run.figures["error_largest_mm"] = worst;
  run.say("against the truth: mean " + fixed(sum, 3) + " mm, largest " + fixed(worst, 3) + " mm");
  if (found.points.size() != truth.points.size())
    run.warn(std::to_string(found.points.size()) + " markers found where there are truly " +
             std::to_string(truth.points.size()) + "; change --threshold or the sizes");
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path out = arguments.path("out"), input = arguments.path("INPUT");
  run.outputs.announce(out);
  run.outputs.announce(sidecarOf(out));
  Landmarks truth;
  if (arguments.has("truth")) truth = run.landmarks(arguments.path("truth"));
  const Landmarks clicks = seedPointsOf(arguments, run);
  const bool all = arguments.has("all");
  if (all == !clicks.points.empty())
    throw InputError(all ? "--all finds markers without clicks; leave out --seed and --seeds"
                         : "no click is given; give --seed, --seeds or, for a CT, --all");
  run.progress.report(0, "Locating");
  const bool volume = isVolumeFile(input) || isDicom(input);
  const Landmarks found = (volume ? inCt : inScan)(arguments, clicks, run);
  run.figures["found"] = found.points.size();
  run.frames = {{out.filename().string(), volume ? "patient LPS, mm" : found.frame + ", mm"}};
  if (arguments.has("truth")) compare(found, truth, run);
  writeLandmarks(run.outputs.staged(out), found, Overwrite::Replace);
  run.writeSidecar(sidecarOf(out));
  run.say(out.string() + ": " + std::to_string(found.points.size()) + " markers located");
}

}  // namespace

Command locateCommand() {
  return {"locate", "Locate markers", "Finds the centres of spheres and beads in a CT or a scan.", declare,
          execute};
}

}  // namespace falciform::commandline
