#pragma once
#include <optional>
#include <string>
#include <vector>

#include "Modules/CommandLine/TrialOutcome.h"

namespace falciform::commandline {

/// One row a registration, C locale, units in the names, empty cells where there is no value; times in the
/// last columns, since they alone differ from run to run.
[[nodiscard]] std::string trialsCsv(const TrialOutcome& outcome);

// A record as it is kept while trials run: all of it, in all digits.
[[nodiscard]] std::string keptRowsHead();
[[nodiscard]] std::string keptRow(const TrialRecord& record, const std::vector<TrialMethod>& methods);
/// The record of such a row; nothing if the row is damaged or of another method.
[[nodiscard]] std::optional<TrialRecord> recordOfKeptRow(const std::string& row,
                                                         const std::vector<TrialMethod>& methods);

}  // namespace falciform::commandline
