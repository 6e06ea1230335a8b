#pragma once
#include <QString>
#include <string>
#include <vector>

#include "Logic/Atlas/ModelUpdateLogic.h"
#include "Modules/AtlasUpdate/UpdateWatch.h"

namespace falciform {

// What the page of the model update says, apart from where it says it.

/// Whether there is a model, whether it is that of the settings, and what to do.
[[nodiscard]] QString updateModelState(const ModelUpdateLogic& logic);
/// "Iteration 12: RMS residual 1.84 mm (fit), bending 4.2 mm, expected error 2.9 mm".
[[nodiscard]] QString liveWords(const std::vector<UpdateRecord>& records);
/// How it ended, and its figures.
[[nodiscard]] QString updateFigures(const UpdateResult& update);
/// How far to trust it, in plain words: on average, at each tumour, and where the scan says least.
[[nodiscard]] QString confidenceWords(const UpdatedCase& made);
/// Of the update, and whether it errs more than the registration expects to.
[[nodiscard]] std::vector<std::string> updateWarnings(const UpdatedCase& made);

}  // namespace falciform
