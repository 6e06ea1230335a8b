#include <gtest/gtest.h>

#include "Logic/Core/Draws.h"
#include "Logic/Deformation/Cohort/GroupComparison.h"
#include "Testing/Logic/Deformation/Cohort/RandomCohort.h"

namespace falciform::test {
namespace {

constexpr int kSeeds = 100;

TEST(NullCohort, WithoutAnyPatternTheExactTestFindsOneAsRarelyAsItSays) {
  for (const double commonPattern : {0.0, 1.0}) {
    SCOPED_TRACE(commonPattern);
    int found = 0, foundInC = 0;
    for (int seed = 0; seed < kSeeds; ++seed) {
      const Cohort cohort = randomCohort(0, static_cast<std::uint64_t>(seed), commonPattern);
      found += compareAllGroups(cohort).permutation.pGreater <= 0.05;
      foundInC += compareGroup(cohort, 2).permutation.pGreater <= 0.05;
    }
    // 5 of 100 expected, standard deviation 2.2: more than 13 happen once in 2000 times if the test is
    // honest.
    EXPECT_LE(found, 13);
    EXPECT_LE(foundInC, 13);
  }
}

TEST(NullCohort, APatternByGroupIsFoundAndLostWhenTheGroupsAreShuffled) {
  int found = 0, foundShuffled = 0;
  double in = 0, out = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    Cohort cohort = randomCohort(0.7, static_cast<std::uint64_t>(seed));
    const GroupComparison all = compareAllGroups(cohort);
    in += all.inGroup.mean / kSeeds;
    out += all.outGroup.mean / kSeeds;
    found += all.permutation.pGreater <= 0.05;
    Draws draws(static_cast<std::uint64_t>(seed), 1);
    for (std::size_t k = cohort.groupOf.size() - 1; k > 0; --k)
      std::swap(cohort.groupOf[k],
                cohort.groupOf[static_cast<std::size_t>(draws.uniform() * static_cast<double>(k + 1))]);
    foundShuffled += compareAllGroups(cohort).permutation.pGreater <= 0.05;
  }
  EXPECT_GE(found, 95);
  EXPECT_LE(foundShuffled, 13);
  EXPECT_NEAR(in, 0.7, 0.1);  // the share that a group has in common; its mean over 700 pairs
  EXPECT_NEAR(out, 0, 0.05);
}

}  // namespace
}  // namespace falciform::test
