#pragma once
#include <QString>
#include <string>
#include <vector>

#include "Logic/Atlas/ModelUpdateLogic.h"

namespace falciform {

/// One iteration of a running update, as the panel shows it.
struct UpdateRecord {
  int iteration = 0;
  double rmsMm = 0, bendMm = 0;
  double expectedMm = 0;  ///< over a sample of the surface; NaN where it was not reckoned
};

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
