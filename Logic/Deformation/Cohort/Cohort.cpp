#include "Logic/Deformation/Cohort/Cohort.h"

#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/Core/NumberText.h"

namespace falciform {

namespace {

void checkEntries(const Cohort& cohort) {
  const Eigen::MatrixXd& c = cohort.correlation;
  const auto name = [&](Index i) { return "'" + cohort.cases[static_cast<std::size_t>(i)] + "'"; };
  for (Index i = 0; i < c.rows(); ++i)
    for (Index j = 0; j < i; ++j) {
      if (!(std::abs(c(i, j)) <= 1 + 1e-9))
        throw InputError("the correlation of cases " + name(j) + " and " + name(i) + " is " +
                         numberText(c(i, j)) + "; give a number from -1 to 1");
      if (!(std::abs(c(i, j) - c(j, i)) <= 1e-6))
        throw InputError("the correlation of cases " + name(j) + " and " + name(i) + " is " +
                         numberText(c(j, i)) + " above the diagonal and " + numberText(c(i, j)) +
                         " below; leave one of them empty or mend it");
    }
}

}  // namespace

void checkCohort(const Cohort& cohort) {
  const auto n = static_cast<Index>(cohort.cases.size());
  if (n < 3)
    throw InputError("the cohort has " + std::to_string(n) + " cases; three are the least to be compared");
  if (cohort.correlation.rows() != n || cohort.correlation.cols() != n)
    throw InputError("the matrix is " + std::to_string(cohort.correlation.rows()) + " x " +
                     std::to_string(cohort.correlation.cols()) + " for " + std::to_string(n) +
                     " cases; give a row and a column for each");
  if (cohort.groupOf.size() != cohort.cases.size())
    throw InputError(std::to_string(cohort.groupOf.size()) + " of " + std::to_string(n) +
                     " cases have a group; say of each which it is, or that it has none");
  checkEntries(cohort);
  bool same = false, different = false;
  for (std::size_t i = 0; i < cohort.cases.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      (cohort.groupOf[i] >= 0 && cohort.groupOf[i] == cohort.groupOf[j] ? same : different) = true;
  if (!same)
    throw InputError("no group has two cases or more, so none can be compared; name the same group for two");
  if (!different)
    throw InputError("all cases are of one group, so there is nothing to compare it with; add others");
}

Cohort withoutCase(const Cohort& cohort, Index left) {
  std::vector<Index> kept;
  Cohort rest;
  rest.groups = cohort.groups;
  for (Index i = 0; i < static_cast<Index>(cohort.cases.size()); ++i) {
    if (i == left) continue;
    kept.push_back(i);
    rest.cases.push_back(cohort.cases[static_cast<std::size_t>(i)]);
    rest.groupOf.push_back(cohort.groupOf[static_cast<std::size_t>(i)]);
  }
  rest.correlation = cohort.correlation(kept, kept);
  return rest;
}

}  // namespace falciform
