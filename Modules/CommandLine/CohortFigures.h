#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "Logic/Deformation/Cohort/CohortAnalysis.h"
#include "Modules/CommandLine/CohortInput.h"

namespace falciform::commandline {

/// All figures of the analysis, with null where there is no value.
[[nodiscard]] nlohmann::json cohortFigures(const CohortInput& input, const CohortAnalysis& analysis);

/// A row a group and one for all groups.
[[nodiscard]] std::string groupsCsv(const Cohort& cohort, const CohortAnalysis& analysis);
/// The same rows for each case left out.
[[nodiscard]] std::string leaveOneOutCsv(const Cohort& cohort, const CohortAnalysis& analysis);
/// Each case's mean correlation with the other cases of each group.
[[nodiscard]] std::string likenessCsv(const Cohort& cohort, const CohortAnalysis& analysis);
/// The whole matrix, as --matrix takes it.
[[nodiscard]] std::string correlationCsv(const Cohort& cohort);

/// Of the row of all groups.
inline constexpr char kAllGroups[] = "all groups";
/// The case's group; empty if it is in none.
[[nodiscard]] std::string groupNameOf(const Cohort& cohort, std::size_t place);

}  // namespace falciform::commandline
