#include <gtest/gtest.h>

#include "Testing/Support/TemporaryFolder.h"
#include "Testing/Verification/SharedProblems.h"

namespace falciform::verification {
namespace {

class Calculix : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Orders, Calculix, ::testing::Bool(),
                         [](const auto& order) { return order.param ? "Quadratic" : "Linear"; });

TEST_P(Calculix, AgreesToTheDigitsThatItPrints) {
  const auto calculix = findCalculix();
  if (!calculix) GTEST_SKIP() << "CalculiX is not installed (Debian: calculix-ccx)";
  const test::TemporaryFolder folder;
  for (const SharedProblem& problem : sharedProblems(GetParam(), 1)) {
    const Points theirs = solveWithCalculix(problem, *calculix, folder.path());
    const Points ours = solve(problem.body).displacements;
    // Of the largest displacement: it prints seven digits of each component, 0.5e-6 of one at worst.
    EXPECT_LT(largest(ours - theirs), 1e-6 * largest(ours)) << problem.name;
    EXPECT_GT(largest(ours), 0) << problem.name;
  }
}

}  // namespace
}  // namespace falciform::verification
