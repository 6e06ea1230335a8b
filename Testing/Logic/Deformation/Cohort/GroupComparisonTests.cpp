#include "Logic/Deformation/Cohort/GroupComparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "Logic/Core/Draws.h"

namespace falciform {
namespace {

Cohort cohortOf(std::vector<int> groupOf, int groups, std::uint64_t seed) {
  const auto n = static_cast<Index>(groupOf.size());
  Draws draws(seed);
  Cohort cohort;
  cohort.correlation = Eigen::MatrixXd::Identity(n, n);
  for (Index i = 0; i < n; ++i) {
    cohort.cases.push_back("case" + std::to_string(i));
    for (Index j = 0; j < i; ++j) cohort.correlation(i, j) = cohort.correlation(j, i) = draws.uniform(-1, 1);
  }
  for (int g = 0; g < groups; ++g) cohort.groups.push_back(std::string(1, static_cast<char>('A' + g)));
  cohort.groupOf = std::move(groupOf);
  return cohort;
}

/// In-group mean less out-group mean over pairs, the cases taken in the order `place`.
double difference(const Cohort& cohort, const std::vector<Index>& place, int group) {
  double in = 0, out = 0;
  int inCount = 0, outCount = 0;
  for (std::size_t i = 0; i < place.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const int a = cohort.groupOf[i], b = cohort.groupOf[j];
      const double c = cohort.correlation(place[i], place[j]);
      const bool same = group >= 0 ? a == group && b == group : a >= 0 && a == b;
      if (same) {
        in += c;
        ++inCount;
      } else if (group < 0 || a == group || b == group) {
        out += c;
        ++outCount;
      }
    }
  return in / inCount - out / outCount;
}

/// Shares of all n! orders of the cases whose difference is as large as the true one.
std::pair<double, double> overAllOrders(const Cohort& cohort, int group) {
  std::vector<Index> place(cohort.cases.size());
  std::iota(place.begin(), place.end(), Index(0));
  const double truth = difference(cohort, place, group);
  double all = 0, greater = 0, twoSided = 0;
  do {
    const double d = difference(cohort, place, group);
    ++all;
    greater += d >= truth - 1e-12;
    twoSided += std::abs(d) >= std::abs(truth) - 1e-12;
  } while (std::next_permutation(place.begin(), place.end()));
  return {greater / all, twoSided / all};
}

TEST(GroupComparison, AgreesWithACalculationByHand) {
  Cohort cohort = cohortOf({0, 0, -1, -1}, 1, 1);
  cohort.correlation << 1, 0.8, 0.1, 0.3,  //
      0.8, 1, -0.2, 0.2,                   //
      0.1, -0.2, 1, 0.9,                   //
      0.3, 0.2, 0.9, 1;
  const GroupComparison group = compareGroup(cohort, 0);
  EXPECT_EQ(group.cases, 2);
  EXPECT_EQ(group.inGroup.count, 1);
  EXPECT_DOUBLE_EQ(group.inGroup.mean, 0.8);
  EXPECT_EQ(group.outGroup.count, 4);  // the pair of the two others belongs to neither
  EXPECT_NEAR(group.outGroup.mean, 0.1, 1e-15);
  EXPECT_NEAR(group.difference(), 0.7, 1e-15);
  EXPECT_TRUE(std::isnan(group.pooled.p));  // one pair
  // Of the six pairs as the group, only that of the two others (0.9 - 0.1) gives as much.
  EXPECT_DOUBLE_EQ(group.permutation.pGreater, 2.0 / 6);
  EXPECT_DOUBLE_EQ(group.leastP, 1.0 / 6);
  const GroupComparison all = compareAllGroups(cohort);  // here that pair is of different procedures
  EXPECT_EQ(all.outGroup.count, 5);
  EXPECT_NEAR(all.outGroup.mean, 1.3 / 5, 1e-15);
  EXPECT_DOUBLE_EQ(all.permutation.pGreater, 2.0 / 6);
}

TEST(GroupComparison, ExactTestsAreThoseOverAllOrdersOfTheCases) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    SCOPED_TRACE(seed);
    const Cohort cohort = cohortOf({0, 1, -1, 1, 0, -1, 1}, 2, seed);
    for (int group = 0; group < 2; ++group) {
      const PermutationTest test = compareGroup(cohort, group).permutation;
      const auto [greater, twoSided] = overAllOrders(cohort, group);
      ASSERT_TRUE(test.exact);
      EXPECT_NEAR(test.pGreater, greater, 1e-14);
      EXPECT_NEAR(test.pTwoSided, twoSided, 1e-14);
    }
    const PermutationTest all = compareAllGroups(cohort).permutation;
    EXPECT_EQ(all.tried, 210);  // 7! / (2! 3! 2!)
    EXPECT_NEAR(all.pGreater, overAllOrders(cohort, -1).first, 1e-14);
    EXPECT_NEAR(all.pTwoSided, overAllOrders(cohort, -1).second, 1e-14);
  }
}

TEST(GroupComparison, LeastPIsReachedByThePerfectCohort) {
  Cohort cohort = cohortOf({0, 0, 0, 1, 1, 1, -1}, 2, 1);
  for (Index i = 0; i < 7; ++i)
    for (Index j = 0; j < 7; ++j) {
      const int a = cohort.groupOf[static_cast<std::size_t>(i)],
                b = cohort.groupOf[static_cast<std::size_t>(j)];
      cohort.correlation(i, j) = i == j || (a >= 0 && a == b) ? 1 : -0.5;
    }
  const GroupComparison all = compareAllGroups(cohort);
  EXPECT_DOUBLE_EQ(all.leastP, 2.0 / 140);  // the two groups may change names
  EXPECT_DOUBLE_EQ(all.permutation.pGreater, all.leastP);
  const GroupComparison one = compareGroup(cohort, 1);
  EXPECT_DOUBLE_EQ(one.leastP, 1.0 / 35);
  EXPECT_DOUBLE_EQ(one.permutation.pGreater, 2.0 / 35);  // the other group is as good
}

TEST(GroupComparison, OfAGroupWithoutPairsHasNoFigures) {
  const GroupComparison alone = compareGroup(cohortOf({0, 0, 1}, 2, 1), 1);
  EXPECT_EQ(alone.inGroup.count, 0);
  EXPECT_EQ(alone.outGroup.count, 2);
  EXPECT_TRUE(std::isnan(alone.permutation.pGreater));
  EXPECT_TRUE(std::isnan(alone.difference()));
}

TEST(GroupComparison, DoesNotLookAtTheDiagonalOrTheOrderOfCases) {
  const Cohort cohort = cohortOf({0, 1, 0, 1, 0, -1}, 2, 9);
  Cohort turned = cohort;
  turned.correlation.diagonal().setConstant(0.3);
  turned.correlation = turned.correlation.reverse().eval();
  std::reverse(turned.groupOf.begin(), turned.groupOf.end());
  const GroupComparison a = compareGroup(cohort, 0), b = compareGroup(turned, 0);
  EXPECT_NEAR(a.pooled.p, b.pooled.p, 1e-12);
  EXPECT_NEAR(a.welch.p, b.welch.p, 1e-12);
  EXPECT_EQ(a.permutation.pGreater, b.permutation.pGreater);
}

}  // namespace
}  // namespace falciform
