#pragma once
#include <string>

#include "Modules/CommandLine/TrialOutcome.h"

namespace falciform::commandline {

// The tables of a report on trials, each as HTML.

/// In the form of the thesis's Tables III.1 and III.2, or III.5 and III.6 where there are no targets.
[[nodiscard]] std::string successTable(const TrialOutcome& outcome);
/// What the counts prove, and what was flagged.
[[nodiscard]] std::string proofTable(const TrialOutcome& outcome);
/// A sentence where a method's trials are one experiment, or nothing.
[[nodiscard]] std::string alikeNote(const TrialOutcome& outcome);
/// How many poses the trials ended in, and how many near the gold standard.
[[nodiscard]] std::string poseTable(const TrialOutcome& outcome);
/// Median, P95, P99 and largest of target error and residual.
[[nodiscard]] std::string spreadTable(const TrialOutcome& outcome);
/// In the form of the thesis's Table III.7, over the successful registrations, and the spread over all.
[[nodiscard]] std::string timeTable(const TrialOutcome& outcome);
/// One row a setting, one column a method.
[[nodiscard]] std::string methodSettingsTable(const TrialOutcome& outcome);

}  // namespace falciform::commandline
