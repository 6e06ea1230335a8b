#include "Logic/Atlas/BentImages.h"
#include "Logic/Core/Errors.h"
#include "Logic/Deformation/DistanceMapping.h"
#include "Logic/Deformation/Normalisation/CarriedImages.h"
#include "Logic/Deformation/Normalisation/LiverRegistration.h"
#include "Logic/Deformation/Normalisation/SurfaceErrors.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/IO/DisplacementFiles.h"
#include "Logic/IO/ResultFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Logic/Segmentation/SurfaceImport.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/NormalisePicture.h"

namespace falciform::commandline {

namespace fs = std::filesystem;

namespace {

constexpr double kMarginMm = 20, kGridMm = 3;  // around the liver, and of the displacement grid
constexpr char kMoved[] = "source_on_target.vtp", kTarget[] = "target.vtp", kTable[] = "normalise.csv",
               kGrid[] = "source_from_target.nrrd", kLabels[] = "source_labels_on_target.nii.gz",
               kImage[] = "source_image_on_target.nii.gz", kSidecar[] = "normalise.json",
               kPicture[] = "normalise.png";

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files", help = "Label map, or closed surface in LPS mm.";
  syntax.add({.name = "target",
              .kind = File,
              .label = "Target liver",
              .help = help,
              .required = true,
              .group = group});
  syntax.add({.name = "source",
              .kind = File,
              .label = "Source liver",
              .help = help,
              .required = true,
              .group = group});
  syntax.add({.name = "source-image",
              .kind = File,
              .label = "Source image",
              .help = "CT of the source patient, to be brought onto the target.",
              .group = group});
  syntax.add({.name = "target-image",
              .kind = File,
              .label = "Target image",
              .help = "CT of the target patient, for --measure mutual-information.",
              .group = group});
  syntax.add({.name = "measure",
              .kind = Choice,
              .label = "Measure",
              .help = "What is made alike: signed distances to the two surfaces, or the grey values of the "
                      "two CTs in and around the liver.",
              .fallback = "distance",
              .choices = {"distance", "mutual-information"},
              .group = "Registration"});
  syntax.add({.name = "out",
              .kind = Folder,
              .label = "Result folder",
              .help = "Receives source_on_target.vtp, target.vtp, source_from_target.nrrd, normalise.csv, "
                      "normalise.png, normalise.json, and source_labels_on_target.nii.gz and "
                      "source_image_on_target.nii.gz where there are such.",
              .required = true,
              .output = true,
              .group = group});
  syntax.addSettings(NormalisationSettings{}, "Registration");
  syntax.addResult({"source_to_target_mm", "Mean distance of the source's surface from the target's", "mm"});
  syntax.addResult({"target_to_source_mm", "Mean distance of the target's surface from the source's", "mm"});
  syntax.addResult({"least_determinant", "Smallest det J", ""});
}

struct Patient {
  falciform::Surface surface;
  falciform::LabelMap labels;  ///< no voxels where a surface was given
};

Patient read(const fs::path& file, CommandRun& run) {
  Patient patient;
  if (!isVolume(file)) {
    patient.surface = run.mesh(file);
    return patient;
  }
  patient.labels = run.labelMap(file);
  SurfaceImportResult imported = importSurface(patient.labels, {});
  run.warn(imported.warnings);
  patient.surface = std::move(imported.surface);
  return patient;
}

/// A lattice in the target's LPS, some millimetres around its surface.
DisplacementGrid carrierGrid(const falciform::Surface& target) {
  const auto box = boundingBox(target.points);
  const Vector3d low = box.row(0).transpose().array() - kMarginMm,
                 size = (box.row(1) - box.row(0)).transpose().array() + 2 * kMarginMm;
  DisplacementGrid grid;
  grid.size = (size / kGridMm).array().ceil().cast<int>() + 1;
  grid.worldFromIndex.topLeftCorner<3, 3>() *= kGridMm;
  grid.worldFromIndex.topRightCorner<3, 1>() = low;
  return grid;
}

std::string csv(const DistanceStatistics& toTarget, const DistanceStatistics& toSource) {
  std::string text = "direction,vertices,mean_mm,sd_mm,median_mm,p95_mm,max_mm\n";
  const auto row = [&](const std::string& name, const DistanceStatistics& s) {
    text += name + "," + std::to_string(s.count);
    for (const double value : {s.mean, s.sd, s.median, s.p95Absolute, s.max}) text += "," + fixed(value, 4);
    text += "\n";
  };
  row("source_to_target", toTarget);
  row("target_to_source", toSource);
  return text;
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const fs::path folder = arguments.path("out"), sourceFile = arguments.path("source");
  const bool labels = isVolume(sourceFile), image = arguments.has("source-image");
  for (const char* name : {kMoved, kTarget, kGrid, kTable, kPicture, kSidecar})
    run.outputs.announce(folder / name);
  if (labels) run.outputs.announce(folder / kLabels);
  if (image) run.outputs.announce(folder / kImage);
  const bool byImages = arguments.text("measure") == "mutual-information";
  if (byImages && !(image && arguments.has("target-image")))
    throw InputError("--measure mutual-information compares two CTs; give --source-image and --target-image");
  const auto settings = arguments.settings(NormalisationSettings{});
  run.settings["normalisation"] = settingsToJson(settings);
  run.settings["measure"] = arguments.text("measure");

  run.progress.report(0, "Reading");
  Patient target = read(arguments.path("target"), run);
  const Patient source = read(sourceFile, run);
  Image ct, targetCt;
  if (image) ct = run.image(arguments.path("source-image"));
  if (byImages) targetCt = run.image(arguments.path("target-image"));
  const Progress registering = run.progress.part(0.15, 0.7);
  const LiverMap map =
      byImages ? registerLivers(target.surface, source.surface, CtPair{targetCt, ct}, settings, registering)
               : registerLivers(target.surface, source.surface, settings, registering);
  run.progress.report(0.7, "Measuring");
  SurfaceErrors errors = surfaceErrors(target.surface, source.surface, map);
  const DistanceStatistics toTarget = distanceStatistics(errors.sourceToTarget),
                           toSource = distanceStatistics(errors.targetToSource);
  const VectorXd ratio = map.determinants(target.surface.points);
  DisplacementGrid grid = carrierGrid(target.surface);
  grid = sampleDisplacements(map, grid.size, grid.worldFromIndex, run.progress.part(0.75, 0.9));

  run.progress.report(0.9, "Writing");
  errors.moved.arrays = {{"distance_to_target_mm", errors.sourceToTarget}};
  target.surface.arrays["distance_to_source_mm"] = errors.targetToSource;
  target.surface.arrays["volume_ratio"] = ratio;
  writeSurface(run.outputs.staged(folder / kMoved), errors.moved, Overwrite::Replace);
  writeSurface(run.outputs.staged(folder / kTarget), target.surface, Overwrite::Replace);
  saveNormaliseSheet(target.surface, source.surface, errors.moved, run.outputs.staged(folder / kPicture),
                     Overwrite::Replace);
  writeDisplacements(run.outputs.staged(folder / kGrid), grid, Overwrite::Replace);
  writeTextFile(run.outputs.staged(folder / kTable), Overwrite::Replace, csv(toTarget, toSource));
  const bool own = !target.labels.voxels.empty();
  const Vector3i size = own ? target.labels.size : grid.size;
  const Matrix4d worldFromIndex = own ? target.labels.worldFromIndex : grid.worldFromIndex;
  if (labels)
    writeLabelMap(run.outputs.staged(folder / kLabels),
                  carryLabels(grid, source.labels, size, worldFromIndex), Overwrite::Replace);
  if (image) {
    const float background = backgroundOf(ct);
    writeImage(run.outputs.staged(folder / kImage), carryImage(grid, ct, background, size, worldFromIndex),
               Overwrite::Replace);
  }
  run.frames = {{kMoved, "the source patient's surface in the target patient's LPS, mm"},
                {kGrid, "on the target patient's LPS, mm; target place + vector = source place"}};
  run.figures = {{"source_to_target", toJson(toTarget)},
                 {"target_to_source", toJson(toSource)},
                 {"source_to_target_mm", toTarget.mean},
                 {"target_to_source_mm", toSource.mean},
                 {"least_determinant", ratio.minCoeff()},
                 {"largest_determinant", ratio.maxCoeff()},
                 {"levels", map.warps.size()}};
  run.writeSidecar(folder / kSidecar);
  const auto tell = [&](const std::string& from, const std::string& to, const DistanceStatistics& s) {
    run.say("from " + from + " to " + to + ": mean " + fixed(s.mean, 2) + ", SD " + fixed(s.sd, 2) +
            ", largest " + fixed(s.max, 2) + " mm");
  };
  tell("source", "target", toTarget);
  tell("target", "source", toSource);
  run.say("det J on the surface from " + fixed(ratio.minCoeff(), 2) + " to " + fixed(ratio.maxCoeff(), 2) +
          "; distances between surfaces say nothing about motion along them");
  run.say("written to " + folder.string());
}

}  // namespace

Command normaliseCommand() {
  return {"normalise", "Bring one liver onto another",
          "Maps one patient's liver smoothly and one to one onto another's, surfaces, labels and CT.",
          declare, execute};
}

}  // namespace falciform::commandline
