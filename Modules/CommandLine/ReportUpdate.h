#pragma once
#include <string>
#include <vector>

#include "Modules/CommandLine/CaseUpdate.h"
#include "Widgets/Rendering/Pictures.h"

namespace falciform::commandline {

/// The model update in a case's report: what it says in plain words, pictures (as HTML), figures, and every
/// target with the error to be expected of it. Empty without an update.
[[nodiscard]] std::string updateSection(const CaseOutcome& outcome, const std::string& pictures);

/// Large figures of it for the report's head.
[[nodiscard]] std::string updateCards(const CaseUpdate& update);

}  // namespace falciform::commandline
