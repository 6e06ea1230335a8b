#pragma once
#include "Logic/Patches/FeatureModel.h"
#include "Testing/Regression/UpdateCase.h"

namespace falciform::test {

/// The pre-op surface of a case with the best suggestions in place of its patches.
[[nodiscard]] Surface suggestedPreop(const UpdateCase& c);

/// What ten dabs of a brush leave of the patches of a scan: five places a patch, spread over it and missed by
/// 3 mm, each with all points within 8 mm.
[[nodiscard]] Surface dabbedScan(const UpdateCase& c, unsigned seed);

/// Mean target error after registering with all patches that both sides have, mm.
[[nodiscard]] double targetErrorMm(const UpdateCase& c, const Surface& preop, const Surface& scan);

}  // namespace falciform::test
