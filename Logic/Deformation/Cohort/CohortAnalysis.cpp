#include "Logic/Deformation/Cohort/CohortAnalysis.h"

#include <limits>

#include "Logic/Core/NumberText.h"

namespace falciform {

namespace {

CaseLeftOut compareAll(const Cohort& cohort, const PermutationSettings& settings, const Progress& progress) {
  CaseLeftOut result;
  for (int g = 0; g < static_cast<int>(cohort.groups.size()); ++g)
    result.groups.push_back(compareGroup(cohort, g, settings, progress));
  result.all = compareAllGroups(cohort, settings, progress);
  return result;
}

Eigen::MatrixXd likenessToGroups(const Cohort& cohort) {
  const auto n = static_cast<Index>(cohort.cases.size()), groups = static_cast<Index>(cohort.groups.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, groups), count = sum;
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const Index group = cohort.groupOf[static_cast<std::size_t>(j)];
      if (i == j || group < 0) continue;
      sum(i, group) += cohort.correlation(i, j);
      count(i, group) += 1;
    }
  return sum.cwiseQuotient(count);  // 0 / 0: NaN, no other case of that group
}

int highest(const Eigen::MatrixXd& values, Index row) {
  double best = -std::numeric_limits<double>::infinity();
  int found = -1;
  for (Index g = 0; g < values.cols(); ++g)
    if (values(row, g) > best) {
      best = values(row, g);
      found = static_cast<int>(g);
    }
  return found;
}

std::vector<std::string> warningsOf(const Cohort& cohort, const std::vector<GroupComparison>& groups) {
  std::vector<std::string> warnings;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::string name = "group '" + cohort.groups[g] + "'";
    if (groups[g].inGroup.count == 0)
      warnings.push_back(name + " has one case, so there is no pair in it to compare");
    else if (groups[g].leastP > 0.05)
      warnings.push_back(name + " has " + std::to_string(groups[g].cases) + " of " +
                         std::to_string(cohort.cases.size()) + " cases, in " +
                         numberText(groups[g].permutation.arrangements) +
                         " arrangements: no result of the permutation test could be below 0.05");
  }
  return warnings;
}

}  // namespace

CohortAnalysis analyseCohort(const Cohort& cohort, const PermutationSettings& settings,
                             const Progress& progress) {
  checkCohort(cohort);
  checkSettings(settings);
  CohortAnalysis analysis;
  CaseLeftOut whole = compareAll(cohort, settings, progress);
  analysis.groups = std::move(whole.groups);
  analysis.all = whole.all;
  const auto n = static_cast<Index>(cohort.cases.size());
  for (Index left = 0; left < n; ++left) {
    progress.report(static_cast<double>(left + 1) / static_cast<double>(n + 1), "Leaving out each case");
    analysis.leaveOneOut.push_back(compareAll(withoutCase(cohort, left), settings, progress));
  }
  analysis.likeness = likenessToGroups(cohort);
  for (Index i = 0; i < n; ++i) analysis.mostAlike.push_back(highest(analysis.likeness, i));
  analysis.warnings = warningsOf(cohort, analysis.groups);
  return analysis;
}

}  // namespace falciform
