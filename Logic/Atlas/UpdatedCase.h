#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "Logic/Atlas/ExpectedError.h"
#include "Logic/Atlas/ModelUpdate.h"
#include "Logic/Core/Case.h"

namespace falciform {

/// Arrays on UpdatedCase::surface, mm.
/// How far a place lies from where the rigid registration puts it.
inline constexpr char kAgainstRigid[] = "against_rigid_mm";

/// A model update with all that a case holds moved along, and what it was made of.
struct UpdatedCase {
  std::shared_ptr<const UpdateModel> model;    ///< nullptr if it was opened with the case
  std::shared_ptr<const Surface> preop, scan;  ///< as they were
  std::shared_ptr<const RegistrationResult> registration;
  UpdateResult update;
  /// The pre-op surface where it is now, scan mm; arrays kDisplacement (beside the update's own rigid
  /// motion), kAgainstRigid, kExpectedError and kScanGain.
  std::shared_ptr<const Surface> surface;
  std::map<std::string, std::shared_ptr<const Surface>> structures;        ///< where they are now, scan mm,
  std::map<std::string, std::shared_ptr<const Surface>> structuresBefore;  ///< and were, pre-op mm
  std::vector<UpdatedTarget> targets;  ///< those of the case, then the middles of the structures
  double expectedErrorMeanMm = 0;      ///< over the surface's points
};

/// What a case keeps of it, and the reverse: with the case as it is, without model, and of the update's own
/// result what was kept.
[[nodiscard]] KeptUpdate keptOf(const UpdatedCase& made);
[[nodiscard]] UpdatedCase updatedFrom(const KeptUpdate& kept, const Case& document);

/// What an update makes of the case's parts. Truth is paired with targets as pairTargets does; where their
/// numbers differ there is none, and a warning.
struct CasePlaces {
  std::shared_ptr<const Surface> preop, scan;
  std::shared_ptr<const RegistrationResult> registration;
  std::map<std::string, std::shared_ptr<const Surface>> structures;
  Landmarks targets, truthTargets;
};
[[nodiscard]] UpdatedCase moveCase(const CasePlaces& places, std::shared_ptr<const UpdateModel> model,
                                   UpdateResult update, const Progress& progress = {});

}  // namespace falciform
