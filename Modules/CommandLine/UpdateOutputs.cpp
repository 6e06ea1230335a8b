#include "Modules/CommandLine/UpdateOutputs.h"

#include "Logic/Atlas/ScanNext.h"
#include "Logic/Atlas/UpdateConfidence.h"
#include "Logic/Atlas/UpdatedPlaces.h"
#include "Logic/Core/LandmarkPairs.h"
#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/PictureTiles.h"
#include "Modules/CommandLine/RegistrationOutputs.h"
#include "Modules/CommandLine/UpdatePicture.h"
#include "Modules/CommandLine/UpdateTargets.h"

namespace falciform::commandline {

namespace fs = std::filesystem;

namespace {

/// The surface with its points where they are now.
falciform::Surface movedSurface(const UpdatedLiver& liver, falciform::Surface surface) {
  const Points moved = scanFromPreop(liver.liver.mesh, liver.update, surface.points);
  surface.arrays[kDisplacement] =
      (moved - transformed(surface.points, liver.update.scanFromPreop)).rowwise().norm();
  surface.points = moved;
  surface.normals.resize(0, 3);
  surface.frame = liver.input.scan.frame;
  return surface;
}

void writeTargets(const UpdatedLiver& liver, const fs::path& file) {
  Landmarks updated = liver.input.targets;
  updated.frame = liver.input.scan.frame;
  const falciform::Points places = positionsOf(updated);
  const falciform::Points now = scanFromPreop(liver.liver.mesh, liver.update, places);
  for (Index i = 0; i < places.rows(); ++i)
    updated.points[static_cast<std::size_t>(i)].position = now.row(i).transpose();
  writeLandmarks(file, updated, Overwrite::Replace);
}

std::optional<TargetError> targetErrorOf(const UpdatedLiver& liver) {
  if (liver.input.truth.points.empty()) return {};
  RegistrationResult bent;
  bent.scanFromPreop = liver.update.scanFromPreop;
  bent.warp = RegistrationWarp{
      [&](const falciform::Points& preop) { return scanFromPreop(liver.liver.mesh, liver.update, preop); },
      liver.moved.points};
  return measureTargetError(liver.input.targets, liver.input.truth, bent, liver.rigid.scanFromPreop);
}

}  // namespace

UpdatedLiver updatedLiver(const LiverInput& liver, const UpdateInput& input, const RegistrationResult& rigid,
                          const UpdateResult& update, const UpdateModel* model) {
  UpdatedLiver updated{liver, input, rigid, update, model, {}, {}, {}};
  updated.moved = movedSurface(updated, liver.surface);
  if (model != nullptr) {
    updated.moved.arrays[kExpectedError] = expectedErrorOnSurface(*model, update, liver.surface.points);
    updated.moved.arrays[kScanGain] =
        scanGainOnSurface(*model, update, positionsOf(input.targets), liver.surface.points);
  }
  updated.targetError = targetErrorOf(updated);
  updated.targets = targetRows(updated);
  return updated;
}

void announceUpdate(const ParsedArguments& arguments, CommandRun& run) {
  announceUpdate(arguments.path("out"), arguments.has("targets"), run);
  run.outputs.announce(arguments.path("out") / "update.json");
  const fs::path picture = picturePath(arguments);
  if (!picture.empty()) run.outputs.announce(picture);
}

void announceUpdate(const fs::path& folder, bool targets, CommandRun& run) {
  run.outputs.announce(folder / "updated.vtp");
  for (const std::string& name : poseFiles()) run.outputs.announce(folder / name);
  if (targets) run.outputs.announce(folder / "targets_updated.mrk.json");
}

void announceStructures(const UpdateInput& input, const fs::path& folder, CommandRun& run) {
  for (const UpdateInput::Structure& structure : input.structures)
    run.outputs.announce(folder / structure.file);
  if (!input.targets.points.empty() || !input.structures.empty()) run.outputs.announce(folder / kTargetTable);
}

void writeUpdate(const UpdatedLiver& liver, const ParsedArguments& arguments, CommandRun& run) {
  writeUpdate(liver, arguments.path("out"), run);
  const fs::path picture = picturePath(arguments);
  if (!picture.empty())
    saveUpdatePicture(liver.liver.surface, liver.moved, liver.input.scan, liver.rigid.scanFromPreop,
                      run.outputs.staged(picture), Overwrite::Replace);
}

void writeUpdate(const UpdatedLiver& liver, const fs::path& folder, CommandRun& run) {
  writeSurface(run.outputs.staged(folder / "updated.vtp"), liver.moved, Overwrite::Replace);
  for (const UpdateInput::Structure& structure : liver.input.structures)
    writeSurface(run.outputs.staged(folder / structure.file), movedSurface(liver, structure.surface),
                 Overwrite::Replace);
  writePose(liver.update.scanFromPreop, folder, run);
  if (!liver.input.targets.points.empty())
    writeTargets(liver, run.outputs.staged(folder / "targets_updated.mrk.json"));
  if (!liver.input.targets.points.empty() || !liver.input.structures.empty())
    writeTextFile(run.outputs.staged(folder / kTargetTable), Overwrite::Replace, targetsCsv(liver.targets));
  run.frames["updated.vtp"] = "the pre-op surface where it is now, in the scan's frame, mm";
  run.frames["scan_from_preop"] = kScanFromPreopInWords;
}

nlohmann::json updateFigures(const UpdatedLiver& liver) {
  const UpdateResult& update = liver.update;
  nlohmann::json figures{{"rms_mm", update.rmsMm},
                         {"noise_mm", update.noiseMm},
                         {"bending_mm", update.bendMm},
                         {"largest_displacement_mm", update.largestMm},
                         {"loads_determined", update.effectiveParameters},
                         {"min_det_j", update.minDetJ},
                         {"iterations", update.iterations},
                         {"converged", update.converged},
                         {"stop_reason", update.stopReason},
                         {"update_s", update.seconds}};
  if (liver.model != nullptr)
    figures["expected_error_mean_mm"] = liver.moved.arrays.at(kExpectedError).mean();
  if (liver.rigid.expectedErrorMeanMm > 0)
    figures["registered_expected_error_mean_mm"] = liver.rigid.expectedErrorMeanMm;
  if (!liver.targets.empty()) figures["targets"] = toJson(liver.targets);
  if (liver.targetError) {
    figures["target_error"] = toJson(*liver.targetError);
    figures["target_error_mean_mm"] = liver.targetError->meanMm;
  }
  return figures;
}

std::vector<std::string> updateWarnings(const UpdatedLiver& liver) {
  if (liver.model == nullptr || liver.update.converged) return {};
  const double expected = liver.moved.arrays.at(kExpectedError).mean(),
               before = liver.rigid.expectedErrorMeanMm;
  if (before <= 0 || expected <= before) return {};
  return {"the update expects to err by " + fixed(expected, 1) + " mm, the rigid registration by " +
          fixed(before, 1) +
          " mm: the scan does not tell this bending; stay with the registration, or scan more of the "
          "surface"};
}

void sayUpdate(const UpdatedLiver& liver, CommandRun& run) {
  const UpdateResult& update = liver.update;
  run.say("fit (not target error): RMS " + fixed(update.rmsMm, 2) + " mm; " + update.stopReason + " after " +
          std::to_string(update.iterations) + " iterations, " + fixed(update.seconds, 2) + " s");
  run.say("largest displacement beside the rigid motion " + fixed(update.largestMm, 1) +
          " mm; smallest local ratio of volumes " + fixed(update.minDetJ, 2));
  if (liver.model != nullptr)
    run.say("expected error: mean " + fixed(liver.moved.arrays.at(kExpectedError).mean(), 1) +
            " mm over the surface");
  if (liver.model != nullptr) {
    const auto regions = expectationByRegion(liver.liver.surface, liver.moved.arrays.at(kScanGain));
    if (!regions.empty())
      run.say("more scanning would help most at " + regions.front().name + ": a patch of it lessens the " +
              (liver.input.targets.points.empty() ? "expected error" : "expected error of the targets") +
              " by about " + fixed(regions.front().meanMm, 2) + " mm");
  }
  if (liver.targetError)
    run.say("target error: mean " + fixed(liver.targetError->meanMm, 2) + " mm, largest " +
            fixed(liver.targetError->maxMm, 2) + " mm; by the rigid registration alone " +
            fixed(liver.targetError->startMeanMm, 2) + ", by the best rigid motion there is " +
            fixed(liver.targetError->optimalRigidMeanMm, 2));
}

void tellUpdate(const UpdatedLiver& liver, CommandRun& run) {
  run.figures = updateFigures(liver);
  run.warn(updateWarnings(liver));
  sayUpdate(liver, run);
}

}  // namespace falciform::commandline
