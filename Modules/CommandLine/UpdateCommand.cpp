#include <sstream>

#include "Logic/Atlas/ModelUpdate.h"
#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/Patches/PatchStatistics.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/LiverInput.h"
#include "Modules/CommandLine/PictureTiles.h"
#include "Modules/CommandLine/RegistrationOutputs.h"
#include "Modules/CommandLine/TargetError.h"
#include "Modules/CommandLine/UpdatePicture.h"

namespace falciform::commandline {
namespace {

namespace fs = std::filesystem;

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files";
  declareLiverInput(syntax, group);
  syntax.add({.name = "scan",
              .kind = Surface,
              .label = "Scan",
              .help = "Surface or point cloud in the scanner's frame, mm.",
              .required = true,
              .group = group});
  syntax.add(
      {.name = "structures",
       .kind = Text,
       .label = "Structures",
       .help = "Surfaces of vessels and tumours, pre-op mm, comma-separated: written where they are now.",
       .group = group});
  syntax.add({.name = "targets",
              .kind = Points,
              .label = "Targets",
              .help = "Points inside the liver, pre-op mm: written where they are now.",
              .group = group});
  syntax.add({.name = "truth-targets",
              .kind = Points,
              .label = "True targets",
              .help = "Where the targets truly are, scan mm, to measure target error.",
              .group = group});
  syntax.add({.name = "init",
              .kind = Text,
              .label = "Rigid pose",
              .help =
                  "Transform file (.tfm, .txt, .json) that maps pre-op mm to scan mm; without it the scan is "
                  "registered first.",
              .group = group});
  syntax.add({.name = "out",
              .kind = Folder,
              .label = "Result folder",
              .help = "Receives updated.vtp, targets_updated.mrk.json, structure surfaces, the rigid part as "
                      "scan_from_preop.*, and update.json.",
              .required = true,
              .output = true,
              .group = group});
  syntax.add({.name = "picture",
              .kind = File,
              .label = "Picture",
              .help = "Also draw the liver before and after the update, and its expected error, .png.",
              .output = true,
              .group = group});
  syntax.addSettings(UpdateSettings{}, "Fit");
  syntax.addSettings(MeshSettings{.edgeLengthMm = 13}, "Mesh, where none is given");
  syntax.addResult({"rms_mm", "RMS residual (fit, not target error)", "mm"});
  syntax.addResult({"expected_error_mean_mm", "Expected target error", "mm"});
  syntax.addResult({"target_error_mean_mm", "Mean target error", "mm"});
  syntax.addResult({"min_det_j", "Smallest local ratio of volumes", ""});
}

struct NamedSurface {
  std::string file;
  falciform::Surface surface;
};

std::vector<NamedSurface> readStructures(const std::string& list, CommandRun& run) {
  std::vector<NamedSurface> read;
  std::istringstream names(list);
  for (std::string name; std::getline(names, name, ',');)
    if (!name.empty()) read.push_back({fs::path(name).stem().string() + "_updated.vtp", run.surface(name)});
  return read;
}

/// The surface with its points where they are now.
falciform::Surface movedSurface(const UpdateModel& model, const UpdateResult& update,
                                falciform::Surface surface, const std::string& frame) {
  const Points moved = scanFromPreop(model, update, surface.points);
  surface.arrays[kDisplacement] =
      (moved - transformed(surface.points, update.scanFromPreop)).rowwise().norm();
  surface.points = moved;
  surface.normals.resize(0, 3);
  surface.frame = frame;
  return surface;
}

/// Expected errors of the mesh's nodes carried to the surface: there are thrice as many surface points as
/// nodes.
VectorXd surfaceExpectation(const UpdateModel& model, const UpdateResult& update) {
  const VectorXd nodes = expectedErrorMm(model, update, model.responses().mesh.points);
  return MeshPlaces(model.responses().mesh, model.preop().points).interpolate(nodes).col(0).cwiseMax(0);
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const fs::path folder = arguments.path("out"), sidecar = folder / "update.json";
  run.outputs.announce(folder / "updated.vtp");
  for (const std::string& name : poseFiles()) run.outputs.announce(folder / name);
  if (arguments.has("targets")) run.outputs.announce(folder / "targets_updated.mrk.json");
  run.outputs.announce(sidecar);
  const fs::path picture = picturePath(arguments);
  if (!picture.empty()) run.outputs.announce(picture);
  if (arguments.has("truth-targets") && !arguments.has("targets"))
    throw InputError("--truth-targets is given without --targets; give both or none");

  const LiverInput liver = readLiverInput(arguments, run, run.progress.part(0, 0.2));
  const falciform::Surface scan = run.surface(arguments.path("scan"));
  const std::vector<NamedSurface> structures = readStructures(arguments.text("structures"), run);
  for (const NamedSurface& structure : structures) run.outputs.announce(folder / structure.file);
  const Landmarks targets = arguments.has("targets") ? run.landmarks(arguments.path("targets")) : Landmarks{};
  const Landmarks truth =
      arguments.has("truth-targets") ? run.landmarks(arguments.path("truth-targets")) : Landmarks{};
  const auto settings = arguments.settings(UpdateSettings{});
  run.settings["update"] = settingsToJson(settings);
  run.warn(patchWarnings(liver.surface, scan));

  const UpdateModel model(liver.surface,
                          solveSurfaceLoads(liver.mesh, {Material{}}, {}, run.progress.part(0.2, 0.7)));
  RegistrationResult rigid;
  if (arguments.has("init")) {
    rigid.scanFromPreop = run.transform(arguments.text("init"));
  } else {
    rigid = registerSurfaces(liver.surface, scan, RegistrationSettings{}, Isometry3d::Identity(),
                             run.progress.part(0.7, 0.8));
    run.warn(rigid.warnings);
  }
  const UpdateResult update = updateModel(model, scan, rigid.scanFromPreop, settings, run.provenance.seed,
                                          run.progress.part(0.8, 0.95));
  run.warn(update.warnings);

  run.figures = {{"rms_mm", update.rmsMm},
                 {"noise_mm", update.noiseMm},
                 {"bending_mm", update.bendMm},
                 {"largest_displacement_mm", update.largestMm},
                 {"loads_determined", update.effectiveParameters},
                 {"min_det_j", update.minDetJ},
                 {"iterations", update.iterations},
                 {"converged", update.converged},
                 {"stop_reason", update.stopReason},
                 {"update_s", update.seconds}};
  run.say("fit (not target error): RMS " + fixed(update.rmsMm, 2) + " mm; " + update.stopReason + " after " +
          std::to_string(update.iterations) + " iterations, " + fixed(update.seconds, 2) + " s");
  run.say("largest displacement beside the rigid motion " + fixed(update.largestMm, 1) +
          " mm; smallest local ratio of volumes " + fixed(update.minDetJ, 2));
  falciform::Surface moved = movedSurface(model, update, liver.surface, scan.frame);
  moved.arrays["expected_error_mm"] = surfaceExpectation(model, update);
  run.figures["expected_error_mean_mm"] = moved.arrays["expected_error_mm"].mean();
  if (!update.converged && rigid.expectedErrorMeanMm > 0 &&
      moved.arrays["expected_error_mm"].mean() > rigid.expectedErrorMeanMm)
    run.warn(
        "the update expects to err by " + fixed(moved.arrays["expected_error_mm"].mean(), 1) +
        " mm, the rigid registration by " + fixed(rigid.expectedErrorMeanMm, 1) +
        " mm: the scan does not tell this bending; stay with the registration, or scan more of the surface");
  writeSurface(run.outputs.staged(folder / "updated.vtp"), moved, Overwrite::Replace);
  if (!picture.empty())
    saveUpdatePicture(liver.surface, moved, scan, rigid.scanFromPreop, run.outputs.staged(picture),
                      Overwrite::Replace);
  for (const NamedSurface& structure : structures)
    writeSurface(run.outputs.staged(folder / structure.file),
                 movedSurface(model, update, structure.surface, scan.frame), Overwrite::Replace);
  writePose(update.scanFromPreop, folder, run);
  if (!targets.points.empty()) {
    Points places(static_cast<Index>(targets.points.size()), 3);
    for (Index i = 0; i < places.rows(); ++i)
      places.row(i) = targets.points[static_cast<std::size_t>(i)].position.transpose();
    const Points now = scanFromPreop(model, update, places);
    Landmarks updated = targets;
    updated.frame = scan.frame;
    for (Index i = 0; i < places.rows(); ++i)
      updated.points[static_cast<std::size_t>(i)].position = now.row(i).transpose();
    writeLandmarks(run.outputs.staged(folder / "targets_updated.mrk.json"), updated, Overwrite::Replace);
    if (!truth.points.empty()) {
      RegistrationResult bent;
      bent.scanFromPreop = update.scanFromPreop;
      bent.warp = RegistrationWarp{[&](const Points& preop) { return scanFromPreop(model, update, preop); },
                                   moved.points};
      const TargetError error = measureTargetError(targets, truth, bent, rigid.scanFromPreop);
      run.figures["target_error"] = toJson(error);
      run.figures["target_error_mean_mm"] = error.meanMm;
      run.say("target error: mean " + fixed(error.meanMm, 2) + " mm, largest " + fixed(error.maxMm, 2) +
              " mm; by the rigid registration alone " + fixed(error.startMeanMm, 2) +
              ", by the best rigid motion there is " + fixed(error.optimalRigidMeanMm, 2));
    }
  }
  run.frames["updated.vtp"] = "the pre-op surface where it is now, in the scan's frame, mm";
  run.frames["scan_from_preop"] = kScanFromPreopInWords;
  run.writeSidecar(sidecar);
  run.say("written to " + folder.string());
}

}  // namespace

Command updateCommand() {
  return {"update", "Update model",
          "Moves the whole pre-operative liver to where a partial scan shows it to be now, bending included.",
          declare, execute};
}

}  // namespace falciform::commandline
