#include "Modules/CommandLine/CaseUpdate.h"

#include <cctype>

#include "Logic/IO/ResultFiles.h"
#include "Modules/CommandLine/UpdateImages.h"

namespace falciform::commandline {

namespace fs = std::filesystem;

namespace {

/// "portal vein" -> "portal_vein_updated.vtp".
std::string updatedFile(std::string name) {
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
  return name + "_updated.vtp";
}

/// Why the surface cannot be filled with tetrahedra, or empty.
std::string whyNot(const falciform::Surface& preop) {
#ifndef FALCIFORM_WITH_UPDATE
  return "this build is without TetGen or CHOLMOD";
#else
  const TopologyReport topology = inspectTopology(preop);
  if (topology.closedManifold() && topology.components == 1) return "";
  return "the pre-op surface must be closed and of one piece, and is: " + describeTopology(topology);
#endif
}

UpdateInput inputOf(const CaseDescription& description, const CaseSettings& settings,
                    const CaseOutcome& outcome, CommandRun& run) {
  UpdateInput input;
  input.scan = *outcome.scan;
  for (const auto& [name, surface] : outcome.structures)
    input.structures.push_back({name, updatedFile(name), *surface});
  if (!description.targets.empty()) input.targets = run.landmarks(description.folder / description.targets);
  if (!description.targets.empty() && !description.truthTargets.empty())
    input.truth = run.landmarks(description.folder / description.truthTargets);
  input.settings = settings.update;
  return input;
}

ImageOutputsPlan imagesOf(const CaseDescription& description, const CaseSettings& settings,
                          const fs::path& folder) {
  const auto file = [&](const std::string& name) {
    return name.empty() ? fs::path() : description.folder / name;
  };
  return {.ct = file(description.ct),
          .labels = file(description.labelMap),
          .grid = folder / "displacement.nrrd",
          .toolTips = {},
          .gridSpacingMm = settings.gridSpacingMm,
          .frame = settings.imagesIn};
}

void writeUpdateSidecar(const CaseSettings& settings, const fs::path& file, CommandRun& run) {
  nlohmann::json sidecar = run.sidecar();
  sidecar["figures"] = run.figures["update"];
  sidecar["settings"] = {{"mesh", settingsToJson(settings.mesh)},
                         {"update", settingsToJson(settings.update)}};
  writeTextFile(run.outputs.staged(file), Overwrite::Replace, sidecar.dump(2) + "\n");
}

}  // namespace

std::shared_ptr<const CaseUpdate> updateCase(const CaseDescription& description, const CaseSettings& settings,
                                             const CaseOutcome& outcome, CommandRun& run,
                                             const Progress& progress) {
  if (!settings.withUpdate) return nullptr;
  if (const std::string why = whyNot(*outcome.preop); !why.empty()) {
    run.warn("the model was not updated: " + why);
    return nullptr;
  }
  auto made = std::make_shared<CaseUpdate>();
  made->rigid = outcome.registration;
  made->input = inputOf(description, settings, outcome, run);
  made->liver.surface = *outcome.preop;
  LiverMesh mesh = meshLiver(*outcome.preop, {}, settings.mesh, progress.part(0, 0.2));
  run.warn(mesh.report.warnings);
  made->liver.mesh = std::move(mesh.mesh);
  made->model.emplace(*outcome.preop,
                      solveSurfaceLoads(made->liver.mesh, {Material{}}, {}, progress.part(0.2, 0.8)));
  made->result = updateModel(*made->model, *outcome.scan, outcome.registration->scanFromPreop,
                             settings.update, run.provenance.seed, progress.part(0.8, 0.93));
  run.warn(made->result.warnings);
  made->updated.emplace(updatedLiver(made->liver, made->input, *made->rigid, made->result, &*made->model));
  run.warn(updateWarnings(*made->updated));
  made->distance = mapDistances(made->updated->moved, *outcome.scan, Isometry3d::Identity(),
                                settings.distance, progress.part(0.93, 1));
  return made;
}

void announceCaseUpdate(const CaseDescription& description, const CaseSettings& settings,
                        const fs::path& folder, CommandRun& run) {
  const fs::path place = folder / "update";
  announceUpdate(place, !description.targets.empty(), run);
  for (const auto& [name, unused] : description.structures) run.outputs.announce(place / updatedFile(name));
  if (!description.targets.empty() || !description.structures.empty())
    run.outputs.announce(place / kTargetTable);
  announceImages(imagesOf(description, settings, place), place, run);
  run.outputs.announce(place / "update.json");
}

BentCt writeCaseUpdate(const CaseUpdate& update, const CaseDescription& description,
                       const CaseSettings& settings, const fs::path& folder, CommandRun& run,
                       const Progress& progress) {
  const fs::path place = folder / "update";
  run.figures["update"] = updateFigures(*update.updated);
  run.figures["update"]["scan_distance"] = falciform::toJson(update.distance.scanAll);
  nlohmann::json frames;
  std::swap(frames, run.frames);  // this folder's own, with names of its own
  progress.report(0, "Writing the update");
  writeUpdate(*update.updated, place, run);
  const UpdateMap map(update.liver.mesh, update.result.displacements, update.result.scanFromPreop);
  BentCt bent =
      writeImages(imagesOf(description, settings, place), map, update.liver.mesh, update.result.displacements,
                  update.input.scan.frame, place, run, progress.part(0.1, 1));
  writeUpdateSidecar(settings, place / "update.json", run);
  for (const auto& [name, words] : run.frames.items()) frames["update/" + name] = words;
  run.frames = std::move(frames);
  return bent;
}

}  // namespace falciform::commandline
