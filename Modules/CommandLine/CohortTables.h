#pragma once
#include "Modules/CommandLine/CohortChain.h"

namespace falciform::commandline {

// The tables of a cohort's chain in the thesis's layout.

/// Table IV.3: closest-point errors of the inter-patient registration, source to target, target to source,
/// and over the overlap.
[[nodiscard]] std::string surfaceErrorsCsv(const CohortOutcome& outcome);
/// Table IV.4 and more: the rigid registration, coverage, and the signed distance of each case.
[[nodiscard]] std::string casesCsv(const CohortOutcome& outcome);
/// The maps of one metric on the target's vertices, as `--maps` takes them.
[[nodiscard]] std::string mapsCsv(const CohortOutcome& outcome, std::size_t metric);

/// Tables IV.3 to IV.7 as Markdown; measured and true correlations side by side.
[[nodiscard]] std::string tablesMarkdown(const CohortOutcome& outcome);
/// Tables IV.3 and IV.4 as sections of a report.
[[nodiscard]] std::string tablesHtml(const CohortOutcome& outcome);

}  // namespace falciform::commandline
