#include <gtest/gtest.h>

#include <cmath>

#include "Logic/Core/Draws.h"
#include "Logic/Deformation/Cohort/CohortAnalysis.h"
#include "Logic/Deformation/Cohort/MapCorrelation.h"

namespace falciform {
namespace {

constexpr int kSeeds = 100;

/// Ten cases as the thesis's: three of A, two of B, three of C, two of their own. Maps of 300 vertices that
/// vary smoothly, half of it by group: made of 12 waves whose heights are partly a case's own and partly its
/// group's.
Cohort syntheticCohort(double groupShare, std::uint64_t seed) {
  Cohort cohort;
  cohort.groups = {"A", "B", "C"};
  cohort.groupOf = {-1, -1, 1, 0, 0, 1, 2, 0, 2, 2};
  constexpr Index vertices = 300, waves = 12;
  Eigen::MatrixXd basis(vertices, waves);
  for (Index i = 0; i < vertices; ++i)
    for (Index w = 0; w < waves; ++w)
      basis(i, w) = std::cos(3.14159 * static_cast<double>((w + 1) * i) / vertices);
  Draws draws(seed);
  const auto heights = [&] {
    VectorXd h(waves);
    for (double& value : h) value = draws.normal();
    return h;
  };
  std::vector<VectorXd> ofGroup{heights(), heights(), heights()};
  Eigen::MatrixXd maps(vertices, 10);
  for (std::size_t c = 0; c < 10; ++c) {
    cohort.cases.push_back(std::to_string(c));
    const VectorXd own = heights(), shared = cohort.groupOf[c] < 0
                                                 ? heights()
                                                 : ofGroup[static_cast<std::size_t>(cohort.groupOf[c])];
    maps.col(static_cast<Index>(c)) =
        basis * (std::sqrt(groupShare) * shared + std::sqrt(1 - groupShare) * own);
  }
  cohort.correlation = mapCorrelation(maps, commonCoverage(maps), cohort.cases);
  return cohort;
}

TEST(NullCohort, WithoutAnyPatternTheExactTestFindsOneAsRarelyAsItSays) {
  int found = 0, foundInC = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const Cohort cohort = syntheticCohort(0, static_cast<std::uint64_t>(seed));
    found += compareAllGroups(cohort).permutation.pGreater <= 0.05;
    foundInC += compareGroup(cohort, 2).permutation.pGreater <= 0.05;
  }
  // 5 of 100 expected, standard deviation 2.2: more than 13 happen once in 2000 times if the test is honest.
  EXPECT_LE(found, 13);
  EXPECT_LE(foundInC, 13);
}

TEST(NullCohort, APatternByGroupIsFoundAndLostWhenTheGroupsAreShuffled) {
  int found = 0, foundShuffled = 0;
  double in = 0, out = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    Cohort cohort = syntheticCohort(0.7, static_cast<std::uint64_t>(seed));
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
}  // namespace falciform
