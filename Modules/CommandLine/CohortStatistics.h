#pragma once
#include "Modules/CommandLine/CohortChain.h"

namespace falciform::commandline {

// What one matrix of correlations becomes on disk and on the terminal.

/// groups.csv, leave_one_out.csv, likeness.csv, correlation.csv, correlation.svg.
[[nodiscard]] std::vector<std::string> cohortStatisticsFiles();
/// Writes them into `folder`, where they were announced; returns the picture of the matrix.
std::string writeCohortStatistics(const CohortInput& input, const CohortAnalysis& analysis,
                                  const std::filesystem::path& folder, CommandRun& run);
/// A line a group and one for all.
void tellCohortStatistics(const CohortInput& input, const CohortAnalysis& analysis, int seed,
                          CommandRun& run);

/// The report of the whole chain; `matrices`: one a metric.
[[nodiscard]] std::string chainReportHtml(const CohortFile& cohort, const CohortOutcome& outcome,
                                          const PermutationSettings& settings,
                                          const std::vector<std::string>& matrices,
                                          const std::vector<PictureFile>& pictures,
                                          const Provenance& provenance);

}  // namespace falciform::commandline
