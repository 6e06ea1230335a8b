#pragma once
#include "Logic/Core/Results.h"
#include "Logic/Registration/PatchIcp.h"
#include "Logic/Registration/PreparedPreop.h"

namespace falciform {

/// Residuals, patch residuals, coverage and motion of the pose in `result`. Residuals are real distances of
/// scan points to the nearest pre-op point (unlabelled: fit of the whole surface); patch residuals run to the
/// same label (thesis Tables III.3, III.4). Coverage is that of preop.sample(). `scanTree` is over
/// scan.points.
void fillFigures(RegistrationResult& result, const PreparedPreop& preop, const Surface& scan,
                 const KdTree& scanTree, const LabelledSource& source, const RegistrationSettings& settings,
                 const Isometry3d& scanFromPreopStart);

/// What the user should doubt, in plain words.
[[nodiscard]] std::vector<std::string> registrationWarnings(const RegistrationResult& result,
                                                            const Surface& preop, const Surface& scan,
                                                            const RegistrationSettings& settings);

}  // namespace falciform
