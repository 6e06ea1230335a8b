#pragma once
#include <memory>
#include <optional>

#include "Logic/Atlas/UpdateSettings.h"
#include "Logic/Biomechanics/MeshSettings.h"
#include "Logic/Core/Results.h"
#include "Logic/Deformation/DistanceMapping.h"
#include "Logic/IO/CaseFolder.h"
#include "Logic/Registration/RegistrationSettings.h"
#include "Logic/Segmentation/SurfaceImport.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/ParsedArguments.h"
#include "Modules/CommandLine/PatchSettings.h"
#include "Modules/CommandLine/StartPose.h"
#include "Modules/CommandLine/TargetError.h"
#include "Modules/CommandLine/UpdateImages.h"
#include "Widgets/Rendering/Pictures.h"

namespace falciform::commandline {

/// Settings of every step of a case.
struct CaseSettings {
  SurfaceImportSettings import;
  PatchTransferSettings patches;
  RegistrationSettings registration;
  DistanceSettings distance;
  std::string preset = "default", init;
  MeshSettings mesh{.edgeLengthMm = 13};  ///< coarser than an atlas's: made while someone waits
  UpdateSettings update;
  bool withUpdate = true;
  ImageFrame imagesIn = ImageFrame::Scan;
  double gridSpacingMm = 3;
};

struct CaseUpdate;

/// Declares them all as arguments.
void declareCaseSettings(Syntax& syntax);
/// Defaults, then what case.json says ({"import", "patches", "registration" (with "preset" and "init"),
/// "distance", "mesh", "update"}), then the arguments. Throws InputError for unknown parts.
[[nodiscard]] CaseSettings caseSettings(const CaseDescription& description, const ParsedArguments& arguments);
[[nodiscard]] nlohmann::json toJson(const CaseSettings& settings);

/// What came of a case. Surfaces are shared with the pictures.
struct CaseOutcome {
  std::string name;
  std::shared_ptr<const Surface> preop, scan;
  Structures structures;
  std::optional<SurfaceImportResult> import;  ///< without its surface; none if the case brought a surface
  std::vector<PatchStatistics> preopPatches, scanPatches;
  StartPose start;
  std::shared_ptr<const RegistrationResult> registration;
  std::shared_ptr<const DistanceMap> distance;
  std::shared_ptr<const CaseUpdate> update;  ///< nullptr where there is none
  std::optional<TargetError>
      targetError;  ///< of the registration, where the case has targets and their truth
};

/// Label map or surface, patches, registration, distance map, target error, model update: the main job, in
/// the order of the work. Throws InputError if the case has no scan, or neither surface nor label map.
[[nodiscard]] CaseOutcome runCase(const CaseDescription& description, CaseSettings& settings, CommandRun& run,
                                  const Progress& progress);

}  // namespace falciform::commandline
