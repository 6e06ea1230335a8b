#include "Modules/CommandLine/CaseResults.h"

#include "Logic/IO/ResultFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Modules/CommandLine/DistanceOutputs.h"
#include "Modules/CommandLine/RegistrationOutputs.h"
#include "Modules/CommandLine/ReportHtml.h"
#include "Modules/CommandLine/UpdatePictures.h"

namespace falciform::commandline {

namespace {

const std::vector<std::string> kPictures{"preop.png",     "scan.png",           "before.png",
                                         "after.png",     "distance_preop.png", "distance_scan.png",
                                         "histogram.png", "convergence.png"};

/// One row an iteration of the start that won, C locale.
std::string iterationsCsv(const RegistrationResult& result) {
  std::string csv = "iteration,rms_mm,patch_weight,motion_mm\n";
  for (const IterationRecord& record : result.history)
    csv += std::to_string(record.iteration) + "," + numberText(record.rmsMm) + "," +
           numberText(record.patchWeight) + "," + numberText(record.motionMm) + "\n";
  return csv;
}

std::string targetsCsv(const TargetError& error) {
  std::string csv = "target,error_mm\n";
  for (std::size_t i = 0; i < error.names.size(); ++i) {
    std::string name = error.names[i];
    for (char& c : name)
      if (c == ',' || c == '"' || c == '\n') c = ' ';
    csv += name + "," + numberText(error.errorsMm[static_cast<Index>(i)]) + "\n";
  }
  return csv;
}

std::vector<PictureFile> drawPictures(const CaseOutcome& outcome, const std::filesystem::path& folder,
                                      CommandRun& run, const Progress& progress) {
  PictureSources sources{.preop = outcome.preop,
                         .scan = outcome.scan,
                         .registration = outcome.registration,
                         .distance = outcome.distance,
                         .structures = outcome.structures,
                         .scanFromPreopStart = outcome.start.scanFromPreop};
  const std::filesystem::path staged =
      run.outputs.staged(folder / "pictures" / kPictures.front()).parent_path();
  return savePictures(sources, staged, Overwrite::Replace, {}, progress);
}

}  // namespace

std::vector<std::filesystem::path> caseResultFiles(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files{folder / "preop.vtp", folder / "iterations.csv",
                                           folder / "targets.csv", folder / "report.html",
                                           folder / "run.json"};
  for (const std::string& name : registrationFiles()) files.push_back(folder / name);
  for (const std::string& name : distanceFiles()) files.push_back(folder / name);
  for (const std::string& name : kPictures) files.push_back(folder / "pictures" / name);
  for (const std::string& name : updatePictureNames()) files.push_back(folder / "pictures" / name);
  return files;
}

void writeCaseResults(const CaseOutcome& outcome, const CaseDescription& description,
                      const CaseSettings& settings, const std::filesystem::path& folder, CommandRun& run,
                      const Progress& progress) {
  const auto text = [&](const char* name, const std::string& content) {
    writeTextFile(run.outputs.staged(folder / name), Overwrite::Replace, content);
  };
  run.figures["registration"] = toJson(*outcome.registration);
  run.figures["start"] = outcome.start.words;
  run.figures["distance"] = distanceFigures(*outcome.distance);
  run.figures["preop_patches"] = toJson(outcome.preopPatches);
  run.figures["scan_patches"] = toJson(outcome.scanPatches);
  if (outcome.targetError) run.figures["target_error"] = toJson(*outcome.targetError);
  run.settings = toJson(settings);

  progress.report(0, "Writing");
  run.frames["preop.vtp"] = "patient LPS, mm";
  describeFrames(run);
  writeSurface(run.outputs.staged(folder / "preop.vtp"), *outcome.preop, Overwrite::Replace);
  writeRegistration(*outcome.preop, *outcome.scan, *outcome.registration, folder, run);
  writeDistance(*outcome.distance, folder, run);
  text("iterations.csv", iterationsCsv(*outcome.registration));
  if (outcome.targetError) text("targets.csv", targetsCsv(*outcome.targetError));
  const std::vector<PictureFile> pictures = drawPictures(outcome, folder, run, progress.part(0.1, 0.4));
  std::vector<PictureFile> updated;
  if (outcome.update) {
    const BentCt ct =
        writeCaseUpdate(*outcome.update, description, settings, folder, run, progress.part(0.4, 0.7));
    updated = saveUpdatePictures(*outcome.update, *outcome.distance, outcome.structures, ct,
                                 pictures.front().file.parent_path(), progress.part(0.7, 0.95));
  }
  progress.report(0.95, "Writing the report");
  text("report.html", reportHtml(outcome, settings, run.provenance, pictures, updated));
  run.writeSidecar(folder / "run.json");
}

void tellCaseResults(const CaseOutcome& outcome, const std::filesystem::path& folder, CommandRun& run) {
  tellRegistration(*outcome.registration, outcome.start, run);
  tellDistance(*outcome.distance, run);
  if (outcome.targetError)
    run.say("target error: mean " + fixed(outcome.targetError->meanMm, 2) + " mm, largest " +
            fixed(outcome.targetError->maxMm, 2) + " mm (best possible rigid: mean " +
            fixed(outcome.targetError->optimalRigidMeanMm, 2) + " mm)");
  if (outcome.update) {
    run.say("model update:");
    sayUpdate(*outcome.update->updated, run);
  }
  run.say("pictures: " + (folder / "pictures").string());
  run.say("report:   " + (folder / "report.html").string());
}

}  // namespace falciform::commandline
