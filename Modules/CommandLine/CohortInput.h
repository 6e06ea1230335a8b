#pragma once
#include <filesystem>

#include "Logic/Deformation/Cohort/Cohort.h"
#include "Modules/CommandLine/CommandRun.h"

namespace falciform::commandline {

/// A cohort as it was given.
struct CohortInput {
  Cohort cohort;
  std::string name;                 ///< the matrix's or the maps' file, without folder and extension
  Index vertices = 0, overlap = 0;  ///< of the maps, and those that all cases cover; 0: a matrix was given
};

/// Reads a matrix of correlations: head `case, NAME, NAME, ...`, then a row a case. One half is enough; the
/// diagonal may be empty. Throws InputError naming file, line and remedy.
[[nodiscard]] CohortInput readCorrelationMatrix(const std::filesystem::path& file, CommandRun& run);

/// Reads maps on the vertices of one target liver and correlates them: head of case names, a row a vertex,
/// an empty cell or nan where a case does not cover it. A column `vertex` is passed over.
[[nodiscard]] CohortInput readCohortMaps(const std::filesystem::path& file, CommandRun& run);

/// Reads each case's group: head `case,group`; an empty group is a procedure of its own. Cases that the
/// cohort does not have are warned of.
void readCohortGroups(const std::filesystem::path& file, Cohort& cohort, CommandRun& run);

}  // namespace falciform::commandline
