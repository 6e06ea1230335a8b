#pragma once
#include <vector>

#include "Logic/Deformation/Cohort/GroupComparison.h"

namespace falciform {

/// The comparisons of a cohort without one case: what rests on that case alone.
struct CaseLeftOut {
  std::vector<GroupComparison> groups;
  GroupComparison all;
};

struct CohortAnalysis {
  std::vector<GroupComparison> groups;  ///< as Cohort::groups
  GroupComparison all;
  std::vector<CaseLeftOut> leaveOneOut;  ///< as Cohort::cases
  /// Cases x groups: mean correlation of a case with the other cases of a group; NaN where there is none.
  Eigen::MatrixXd likeness;
  std::vector<int> mostAlike;  ///< of each case: the group of its highest likeness; -1: none has a value
  std::vector<std::string> warnings;
};

/// Thesis Table IV.7 with an exact test beside the thesis's, and what becomes of it without each case. Throws
/// InputError as checkCohort.
[[nodiscard]] CohortAnalysis analyseCohort(const Cohort& cohort, const PermutationSettings& settings = {},
                                           const Progress& progress = {});

}  // namespace falciform
