#include "Logic/Deformation/Cohort/TTest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "Logic/Core/Draws.h"

namespace falciform {
namespace {

TEST(StudentsT, MeetsTheTabulatedQuantiles) {
  // Any table of the distribution, three decimals: the true quantile lies within half of the last place.
  struct Quantile {
    double degrees, p, t;
  };
  for (const Quantile& q : {Quantile{1, 0.05, 12.706},
                            {2, 0.05, 4.303},
                            {5, 0.05, 2.571},
                            {10, 0.05, 2.228},
                            {22, 0.05, 2.074},
                            {30, 0.05, 2.042},
                            {120, 0.05, 1.980},
                            {1, 0.01, 63.657},
                            {10, 0.01, 3.169},
                            {22, 0.1, 1.717},
                            {5, 0.001, 6.869},
                            {22, 0.5, 0.686}}) {
    EXPECT_GT(studentTwoSided(q.t - 0.0005, q.degrees), q.p) << q.degrees << " " << q.t;
    EXPECT_LT(studentTwoSided(q.t + 0.0005, q.degrees), q.p) << q.degrees << " " << q.t;
  }
}

TEST(StudentsT, MeetsItsClosedForms) {
  // Tolerance: the incomplete beta function's 1e-14, with room for cancellation.
  for (const double t : {0.0, 0.1, 0.7, 1.0, 3.5, 40.0}) {
    EXPECT_NEAR(studentTwoSided(t, 1), 1 - 2 / std::numbers::pi * std::atan(t), 1e-12) << t;
    EXPECT_NEAR(studentTwoSided(t, 2), 1 - t / std::sqrt(2 + t * t), 1e-12) << t;
    EXPECT_EQ(studentTwoSided(-t, 3.7), studentTwoSided(t, 3.7)) << t;
    // 1e8 degrees of freedom: off the normal distribution by less than t^3 / 1e8.
    EXPECT_NEAR(studentTwoSided(std::min(t, 4.0), 1e8), std::erfc(std::min(t, 4.0) / std::sqrt(2)), 1e-6);
  }
}

TEST(TTests, AgreeWithACalculationByHand) {
  const SampleMoments a = sampleMoments({1, 2, 3}), b = sampleMoments({2, 4, 6, 8});
  EXPECT_DOUBLE_EQ(a.mean, 2);
  EXPECT_DOUBLE_EQ(a.sd, 1);
  EXPECT_DOUBLE_EQ(b.sd, std::sqrt(20.0 / 3));
  const TTest pooled = pooledTTest(a, b);  // variance (2 * 1 + 3 * 20/3) / 5 = 4.4
  EXPECT_NEAR(pooled.t, -3 / std::sqrt(4.4 * 7 / 12), 1e-12);
  EXPECT_DOUBLE_EQ(pooled.degrees, 5);
  const TTest welch = welchTTest(a, b);  // 1/3 and 5/3 of squared standard error
  EXPECT_NEAR(welch.t, -3 / std::sqrt(2), 1e-12);
  EXPECT_NEAR(welch.degrees, 4 / (1.0 / 18 + 25.0 / 27), 1e-12);
  EXPECT_EQ(welch.p, studentTwoSided(welch.t, welch.degrees));
}

TEST(TTests, AreOneForSamplesOfOneSizeAndSpread) {
  const SampleMoments a = sampleMoments({0, 1, 5}), b = sampleMoments({10, 11, 15});
  EXPECT_NEAR(pooledTTest(a, b).t, welchTTest(a, b).t, 1e-12);
  EXPECT_NEAR(pooledTTest(a, b).degrees, welchTTest(a, b).degrees, 1e-12);
}

TEST(TTests, SayNothingWhereNothingCanBeSaid) {
  const SampleMoments none = sampleMoments({}), one = sampleMoments({3}), flat = sampleMoments({2, 2}),
                      two = sampleMoments({1, 2});
  EXPECT_TRUE(std::isnan(none.mean));
  EXPECT_EQ(one.mean, 3);
  EXPECT_TRUE(std::isnan(one.sd));
  for (const auto& test : {pooledTTest, welchTTest}) {
    EXPECT_TRUE(std::isnan(test(one, two).p));
    EXPECT_TRUE(std::isnan(test(two, none).p));
    EXPECT_TRUE(std::isnan(test(flat, flat).p));
    EXPECT_FALSE(std::isnan(test(flat, two).p));
  }
}

TEST(TTests, RejectAsOftenAsTheySayWhenMeansAreEqual) {
  constexpr int kTrials = 4000;
  Draws draws(7);
  const auto sample = [&](int count, double sd) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(sd * draws.normal());
    return sampleMoments(values);
  };
  int pooledRejects = 0, welchRejects = 0, pooledOfUnequal = 0;
  for (int i = 0; i < kTrials; ++i) {
    pooledRejects += pooledTTest(sample(4, 1), sample(9, 1)).p < 0.05;
    const SampleMoments wide = sample(5, 4), narrow = sample(20, 1);
    welchRejects += welchTTest(wide, narrow).p < 0.05;
    pooledOfUnequal += pooledTTest(wide, narrow).p < 0.05;
  }
  // Four standard deviations of a share of 5 %: 1.4 %. Welch's is an approximation and may err as much again.
  EXPECT_NEAR(pooledRejects / double(kTrials), 0.05, 0.014);
  EXPECT_NEAR(welchRejects / double(kTrials), 0.05, 0.028);
  EXPECT_GT(pooledOfUnequal / double(kTrials), 0.15);  // what unequal spreads do to the pooled one
}

}  // namespace
}  // namespace falciform
