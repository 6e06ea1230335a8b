#include "Modules/CommandLine/CaseRun.h"

#include "Logic/Patches/PatchTransfer.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Modules/CommandLine/CaseUpdate.h"

namespace falciform::commandline {

namespace {

Surface importPreop(const CaseDescription& description, const CaseSettings& settings, CommandRun& run,
                    CaseOutcome& outcome, const Progress& progress) {
  progress.report(0, "Reading the label map");
  const LabelMap map = run.labelMap(description.folder / description.labelMap);
  SurfaceImportResult result = importSurface(map, settings.import, progress.part(0.1, 1));
  run.warn(result.warnings);
  run.figures["import"] = toJson(result);
  Surface surface = std::move(result.surface);
  result.surface = {};
  outcome.import = std::move(result);
  return surface;
}

/// The pre-op surface, made or read, with its patches.
Surface preparePreop(const CaseDescription& description, const CaseSettings& settings, CommandRun& run,
                     CaseOutcome& outcome, const Progress& progress) {
  const bool read = !description.preop.empty();
  if (!read && description.labelMap.empty())
    throw InputError("the case '" + description.name +
                     "' has neither 'preop' nor 'labelMap'; name one in case.json");
  Surface preop = read ? run.mesh(description.folder / description.preop)
                       : importPreop(description, settings, run, outcome, progress);
  if (description.preopPatches.empty()) return preop;
  progress.report(1, "Carrying patches over");
  const Surface painted = run.surface(description.folder / description.preopPatches);
  preop.patch = transferPatches(painted, preop, settings.patches.radiusMm, settings.patches.keepOld);
  preop.patchNames.insert(painted.patchNames.begin(), painted.patchNames.end());
  return preop;
}

Landmarks optionalLandmarks(const CaseDescription& description, const std::string& file, CommandRun& run) {
  return file.empty() ? Landmarks{} : run.landmarks(description.folder / file);
}

void measureTargets(const CaseDescription& description, CommandRun& run, CaseOutcome& outcome) {
  if (description.targets.empty() || description.truthTargets.empty()) return;
  outcome.targetError = measureTargetError(run.landmarks(description.folder / description.targets),
                                           run.landmarks(description.folder / description.truthTargets),
                                           *outcome.registration, outcome.start.scanFromPreop);
}

}  // namespace

CaseOutcome runCase(const CaseDescription& description, CaseSettings& settings, CommandRun& run,
                    const Progress& progress) {
  if (description.scan.empty())
    throw InputError("the case '" + description.name + "' has no 'scan'; name one in case.json");
  CaseOutcome outcome;
  outcome.name = description.name;
  const Surface preop = preparePreop(description, settings, run, outcome, progress.part(0, 0.2));
  const Surface scan = run.surface(description.folder / description.scan);
  for (const auto& [name, file] : description.structures)
    outcome.structures[name] = std::make_shared<const Surface>(run.surface(description.folder / file));
  outcome.preopPatches = patchStatistics(preop);
  outcome.scanPatches = patchStatistics(scan);
  if (looksAtPatches(settings.registration)) run.warn(patchWarnings(preop, scan));

  outcome.start = resolveStart(settings.init, settings.registration,
                               optionalLandmarks(description, description.preopLandmarks, run),
                               optionalLandmarks(description, description.scanLandmarks, run), run);
  outcome.registration = std::make_shared<const RegistrationResult>(registerSurfaces(
      preop, scan, settings.registration, outcome.start.scanFromPreop, progress.part(0.2, 0.4)));
  run.warn(outcome.registration->warnings);
  outcome.distance = std::make_shared<const DistanceMap>(mapDistances(
      preop, scan, outcome.registration->scanFromPreop, settings.distance, progress.part(0.4, 0.5)));
  measureTargets(description, run, outcome);
  outcome.preop = std::make_shared<const Surface>(preop);
  outcome.scan = std::make_shared<const Surface>(scan);
  outcome.update = updateCase(description, settings, outcome, run, progress.part(0.5, 1));
  return outcome;
}

}  // namespace falciform::commandline
