#pragma once
#include <memory>
#include <optional>

#include "Logic/Deformation/DistanceMapping.h"
#include "Modules/CommandLine/CaseRun.h"
#include "Modules/CommandLine/UpdateOutputs.h"

namespace falciform::commandline {

/// The model update of a case, with all that it rests on. Not to be copied: its parts refer to each other.
struct CaseUpdate {
  CaseUpdate() = default;
  CaseUpdate(const CaseUpdate&) = delete;
  CaseUpdate& operator=(const CaseUpdate&) = delete;

  LiverInput liver;
  UpdateInput input;
  std::shared_ptr<const RegistrationResult> rigid;
  std::optional<UpdateModel> model;
  UpdateResult result;
  std::optional<UpdatedLiver> updated;  ///< of all these
  DistanceMap distance;                 ///< between scan and updated surface
};

/// Mesh, answers to loads, fit, everything moved along. nullptr where the case does not want it, and, with a
/// warning that says why, where the liver's surface cannot be filled with tetrahedra.
[[nodiscard]] std::shared_ptr<const CaseUpdate> updateCase(const CaseDescription& description,
                                                           const CaseSettings& settings,
                                                           const CaseOutcome& outcome, CommandRun& run,
                                                           const Progress& progress);

/// Says which files may come into `folder`/update, before any computation; without an update as well, so that
/// none of an older run stays.
void announceCaseUpdate(const CaseDescription& description, const CaseSettings& settings,
                        const std::filesystem::path& folder, CommandRun& run);
/// Writes them: what `falciform update` writes, with the displacement grid, label map and CT where the case
/// has them, and update.json. The figures go into run.figures["update"] too. The bent CT for pictures.
BentCt writeCaseUpdate(const CaseUpdate& update, const CaseDescription& description,
                       const CaseSettings& settings, const std::filesystem::path& folder, CommandRun& run,
                       const Progress& progress);

}  // namespace falciform::commandline
