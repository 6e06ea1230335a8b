#pragma once
#include <QString>
#include <map>
#include <memory>

#include "Logic/Atlas/UpdatedCase.h"
#include "Modules/AtlasUpdate/UpdateWatch.h"
#include "Widgets/Views/ViewState.h"

namespace falciform {

/// An update as the views show it: in the pre-op frame, where the registration puts the scan, so that nothing
/// moves but what the update moves. Arrays on both livers: kSignedDistance to the scan, kAgainstRigid; on the
/// updated one also kExpectedError and kScanGain.
struct UpdateMaps {
  std::shared_ptr<const UpdatedCase> of;
  std::shared_ptr<const Surface> rigid, updated;
  std::map<std::string, std::shared_ptr<const Surface>> rigidStructures, updatedStructures;
  double rigidResidualMm = 0,
         updatedResidualMm = 0;  ///< RMS of the scan's distances, all points that are reached
};
/// Distance maps of both livers; takes a second or so.
[[nodiscard]] std::shared_ptr<const UpdateMaps> mapsOf(std::shared_ptr<const UpdatedCase> made,
                                                       const Progress& progress = {});

enum class UpdateColours { Plain, Motion, Residual, ExpectedError, ScanGain };

/// How the user looks at an update.
struct UpdateLook {
  double share = 1;  ///< 0: as registered, 1: as updated, between: on the way
  UpdateColours colours = UpdateColours::ExpectedError;
  bool compare = false, slices = false;
  bool before = true;  ///< structures also where they were
};

/// The map of these colours, its range that of both livers; none for Plain.
[[nodiscard]] std::optional<ScalarMap> mapFor(UpdateColours colours, const UpdateMaps& maps);
/// Which these colours are and what they are not, one or two sentences.
[[nodiscard]] QString meaningOf(UpdateColours colours);

/// Shows it; without maps, the case as it is registered.
void showUpdate(ViewState& view, const UpdateMaps* maps, const UpdateLook& look);
/// An update that is still running, after `iteration`, with the scan on it. `shape` is of the case's liver.
void showSettling(ViewState& view, const Case& document, const UpdateShape& shape, int iteration);
/// Nothing of it is shown any more.
void hideUpdate(ViewState& view);

}  // namespace falciform
