#pragma once
#include "Logic/Core/Results.h"

namespace falciform::test {

/// Every field set to something of its own.
[[nodiscard]] RegistrationResult sampleRegistration();
/// Statistics on the pre-op side, none (NaN) on the scan's.
[[nodiscard]] DistanceMap sampleDistance();

}  // namespace falciform::test
