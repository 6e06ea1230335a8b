#pragma once
#include <nlohmann/json.hpp>

#include "Modules/CommandLine/TrialOutcome.h"

namespace falciform::commandline {

/// Settings of the trials and of each method: what decides the result, and nothing that does not.
[[nodiscard]] nlohmann::json trialSettingsJson(const TrialOutcome& outcome);
/// Gold standard and one object a method; units in the keys.
[[nodiscard]] nlohmann::json trialFigures(const TrialOutcome& outcome);

}  // namespace falciform::commandline
