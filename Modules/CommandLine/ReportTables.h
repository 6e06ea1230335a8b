#pragma once
#include <string>

#include "Modules/CommandLine/CaseRun.h"

namespace falciform::commandline {

// The tables of a report, one a step. Each returns HTML, empty where the step did not happen.

[[nodiscard]] std::string surfaceSection(const CaseOutcome& outcome);
[[nodiscard]] std::string patchSection(const CaseOutcome& outcome);
[[nodiscard]] std::string registrationSection(const CaseOutcome& outcome);
[[nodiscard]] std::string targetSection(const CaseOutcome& outcome);
[[nodiscard]] std::string distanceSection(const CaseOutcome& outcome);
[[nodiscard]] std::string settingsSection(const CaseSettings& settings);
[[nodiscard]] std::string provenanceSection(const Provenance& provenance);

}  // namespace falciform::commandline
