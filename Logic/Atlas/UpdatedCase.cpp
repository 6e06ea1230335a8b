#include "Logic/Atlas/UpdatedCase.h"

#include <utility>

#include "Logic/Atlas/ExpectedError.h"
#include "Logic/Atlas/ScanNext.h"
#include "Logic/Core/LandmarkPairs.h"

namespace falciform {
namespace {

/// The surface with other points.
Surface withPoints(const Surface& surface, const Points& points, const std::string& frame) {
  Surface moved = surface;
  moved.points = points;
  moved.normals.resize(0, 3);
  moved.frame = frame;
  return moved;
}

std::vector<UpdatedTarget> listTargets(const CasePlaces& places) {
  std::vector<UpdatedTarget> list;
  for (const Landmark& target : places.targets.points) {
    UpdatedTarget one;
    one.name = target.name;
    one.before = target.position;
    list.push_back(one);
  }
  for (const auto& [name, structure] : places.structures) {
    if (structure->size() == 0) continue;
    UpdatedTarget one;
    one.name = name;
    one.structure = true;
    one.before = structure->points.colwise().mean();
    list.push_back(one);
  }
  return list;
}

/// Where the truth is known, how far off both are.
void measure(UpdatedCase& made, const CasePlaces& places) {
  if (places.truthTargets.points.empty()) return;
  if (places.truthTargets.points.size() != places.targets.points.size()) {
    made.update.warnings.push_back("there are " + std::to_string(places.targets.points.size()) +
                                   " targets and " + std::to_string(places.truthTargets.points.size()) +
                                   " true positions: no true error is given");
    return;
  }
  const PairedTargets paired = pairTargets(places.targets, places.truthTargets);
  for (Index i = 0; i < paired.scan.rows(); ++i) {
    UpdatedTarget& target = made.targets[static_cast<std::size_t>(i)];
    const Vector3d truth = paired.scan.row(i).transpose();
    target.trueErrorMm = (target.now - truth).norm();
    target.rigidErrorMm = (target.rigid - truth).norm();
  }
}

}  // namespace

UpdatedCase moveCase(const CasePlaces& places, std::shared_ptr<const UpdateModel> model, UpdateResult update,
                     const Progress& progress) {
  UpdatedCase made;
  made.model = std::move(model);
  made.preop = places.preop;
  made.scan = places.scan;
  made.registration = places.registration;
  made.update = std::move(update);
  progress.report(0, "Moving the surface");
  const Isometry3d& rigid = places.registration->scanFromPreop;
  const Points& before = places.preop->points;
  const Points now = scanFromPreop(*made.model, made.update, before);
  auto surface = std::make_shared<Surface>(withPoints(*places.preop, now, places.scan->frame));
  surface->arrays[kDisplacement] = (now - transformed(before, made.update.scanFromPreop)).rowwise().norm();
  surface->arrays[kAgainstRigid] = (now - transformed(before, rigid)).rowwise().norm();
  progress.report(0.2, "Expected error");
  surface->arrays[kExpectedError] = expectedErrorOnSurface(*made.model, made.update, before);
  made.expectedErrorMeanMm = surface->arrays[kExpectedError].mean();
  made.surface = surface;

  progress.report(0.6, "Moving structures and targets");
  for (const auto& [name, structure] : places.structures) {
    if (structure->size() == 0) continue;
    made.structuresBefore[name] = structure;
    made.structures[name] = std::make_shared<const Surface>(withPoints(
        *structure, scanFromPreop(*made.model, made.update, structure->points), places.scan->frame));
  }
  made.targets = listTargets(places);
  Points middles(static_cast<Index>(made.targets.size()), 3);
  for (Index i = 0; i < middles.rows(); ++i)
    middles.row(i) = made.targets[static_cast<std::size_t>(i)].before.transpose();
  if (middles.rows() > 0) {
    const Points moved = scanFromPreop(*made.model, made.update, middles);
    const VectorXd expected = expectedErrorMm(*made.model, made.update, middles);
    for (Index i = 0; i < middles.rows(); ++i) {
      UpdatedTarget& target = made.targets[static_cast<std::size_t>(i)];
      target.rigid = rigid * target.before;
      target.now = moved.row(i).transpose();
      target.expectedErrorMm = expected[i];
    }
  }
  surface->arrays[kScanGain] = scanGainOnSurface(*made.model, made.update, middles, before);
  measure(made, places);
  progress.report(1);
  return made;
}

KeptUpdate keptOf(const UpdatedCase& made) {
  KeptUpdate kept;
  kept.surface = made.surface;
  kept.structures = made.structures;
  kept.targets = made.targets;
  kept.scanFromPreop = made.update.scanFromPreop;
  kept.expectedErrorMeanMm = made.expectedErrorMeanMm;
  kept.rmsMm = made.update.rmsMm;
  kept.bendMm = made.update.bendMm;
  kept.largestMm = made.update.largestMm;
  kept.minDetJ = made.update.minDetJ;
  kept.effectiveParameters = made.update.effectiveParameters;
  kept.seconds = made.update.seconds;
  kept.iterations = made.update.iterations;
  kept.converged = made.update.converged;
  kept.stopReason = made.update.stopReason;
  kept.warnings = made.update.warnings;
  return kept;
}

UpdatedCase updatedFrom(const KeptUpdate& kept, const Case& document) {
  UpdatedCase made;
  made.preop = document.preop();
  made.scan = document.scan();
  made.registration = document.registration();
  made.surface = kept.surface;
  made.targets = kept.targets;
  for (const auto& [name, structure] : kept.structures)
    if (const auto before = document.structures().find(name); before != document.structures().end()) {
      made.structures[name] = structure;
      made.structuresBefore[name] = before->second;
    }
  made.update.scanFromPreop = kept.scanFromPreop;
  made.expectedErrorMeanMm = kept.expectedErrorMeanMm;
  made.update.rmsMm = kept.rmsMm;
  made.update.bendMm = kept.bendMm;
  made.update.largestMm = kept.largestMm;
  made.update.minDetJ = kept.minDetJ;
  made.update.effectiveParameters = kept.effectiveParameters;
  made.update.seconds = kept.seconds;
  made.update.iterations = kept.iterations;
  made.update.converged = kept.converged;
  made.update.stopReason = kept.stopReason;
  made.update.warnings = kept.warnings;
  return made;
}

}  // namespace falciform
