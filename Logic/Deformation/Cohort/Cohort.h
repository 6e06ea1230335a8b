#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// How alike the deformations of several cases are, and which of them had the same procedure.
struct Cohort {
  std::vector<std::string> cases;
  Eigen::MatrixXd correlation;  ///< n x n, symmetric, each entry in [-1, 1]; the diagonal is not looked at
  std::vector<std::string> groups;
  std::vector<int> groupOf;  ///< of each case: index into `groups`; -1: a procedure of its own, in no group
};

/// Throws InputError, naming the cases, if sizes differ, there are fewer than three cases, the matrix is not
/// symmetric to 1e-6 or an entry is no correlation, or no two cases are of one group and no two of different.
void checkCohort(const Cohort& cohort);

/// All but one case; its group stays even if it is empty now.
[[nodiscard]] Cohort withoutCase(const Cohort& cohort, Index left);

}  // namespace falciform
