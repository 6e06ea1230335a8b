#pragma once
#include "Logic/Deformation/Cohort/Cohort.h"
#include "Logic/Deformation/Cohort/LabelPermutation.h"
#include "Logic/Deformation/Cohort/TTest.h"

namespace falciform {

/// Whether the deformations of one group's cases are more alike than they are to other cases': a row of
/// thesis Table IV.7 and more.
struct GroupComparison {
  Index cases = 0;
  SampleMoments inGroup;   ///< correlations of two cases of the group
  SampleMoments outGroup;  ///< correlations of a case of the group and one that is not
  TTest pooled;            ///< of these as if independent, which they are not: each case stands in many pairs
  TTest welch;             ///< the same
  PermutationTest permutation;  ///< of the difference of the means over the cases' labels: holds as it is
  double leastP = 0;            ///< no arrangement can give less
  [[nodiscard]] double difference() const { return inGroup.mean - outGroup.mean; }
};

/// One group against the cases that are not in it. Labels: in the group or not.
[[nodiscard]] GroupComparison compareGroup(const Cohort& cohort, int group,
                                           const PermutationSettings& settings = {},
                                           const Progress& progress = {});

/// All groups at once: pairs of one group against all other pairs; a case in no group is alike to none by
/// procedure. One test for the whole cohort, where a test a group would be several.
[[nodiscard]] GroupComparison compareAllGroups(const Cohort& cohort, const PermutationSettings& settings = {},
                                               const Progress& progress = {});

}  // namespace falciform
