#pragma once
#include "Logic/Core/Results.h"
#include "Logic/Registration/LabelledTarget.h"
#include "Logic/Registration/PatchIcp.h"

namespace falciform {

/// Residuals, patch residuals, coverage and motion of the pose in `result`. Residuals are real distances of
/// scan points to the nearest pre-op point (unlabelled: fit of the whole surface); patch residuals run to the
/// same label (thesis Tables III.3, III.4).
void fillFigures(RegistrationResult& result, const Surface& preop, const Surface& scan,
                 const LabelledTarget& target, const LabelledSource& source,
                 const RegistrationSettings& settings, const Isometry3d& scanFromPreopStart);

/// What the user should doubt, in plain words.
[[nodiscard]] std::vector<std::string> registrationWarnings(const RegistrationResult& result,
                                                            const Surface& preop, const Surface& scan,
                                                            const RegistrationSettings& settings);

}  // namespace falciform
