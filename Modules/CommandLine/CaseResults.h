#pragma once
#include <filesystem>

#include "Modules/CommandLine/CaseRun.h"

namespace falciform::commandline {

/// Every file that a case run may write into `folder`.
[[nodiscard]] std::vector<std::filesystem::path> caseResultFiles(const std::filesystem::path& folder);

/// Surfaces, transforms, tables, the model update, pictures, report.html and run.json, announced before (the
/// update's files by announceCaseUpdate). `progress` spans the
/// pictures.
void writeCaseResults(const CaseOutcome& outcome, const CaseDescription& description,
                      const CaseSettings& settings, const std::filesystem::path& folder, CommandRun& run,
                      const Progress& progress);

/// Fit, coverage, distances, target error, and where the report lies, on stdout.
void tellCaseResults(const CaseOutcome& outcome, const std::filesystem::path& folder, CommandRun& run);

}  // namespace falciform::commandline
