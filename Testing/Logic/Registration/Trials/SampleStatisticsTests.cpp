#include "Logic/Registration/Trials/SampleStatistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace falciform {
namespace {

TEST(SampleStatistics, MeetsItsClosedFormsOnZeroToAHundredInAnyOrder) {
  std::vector<double> values(101);
  std::iota(values.begin(), values.end(), 0.0);
  std::reverse(values.begin() + 20, values.end());
  const SampleStatistics s = sampleStatistics(values);
  EXPECT_EQ(s.count, 101);
  EXPECT_NEAR(s.mean, 50, 1e-12);
  EXPECT_NEAR(s.sd, std::sqrt(101.0 * 102 / 12), 1e-12);  // n (n + 1) / 12 for 0 ... n - 1
  EXPECT_NEAR(s.median, 50, 1e-12);
  EXPECT_NEAR(s.p95, 95, 1e-12);
  EXPECT_NEAR(s.p99, 99, 1e-12);
  EXPECT_EQ(s.max, 100);
}

TEST(SampleStatistics, InterpolatesBetweenTheMiddleTwo) {
  EXPECT_DOUBLE_EQ(sampleStatistics({1, 4, 2, 8}).median, 3);
}

TEST(SampleStatistics, ValuesThatAreNoNumbersAreLeftOut) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const SampleStatistics s = sampleStatistics({none, 3, none, 5});
  EXPECT_EQ(s.count, 2);
  EXPECT_DOUBLE_EQ(s.mean, 4);
}

TEST(SampleStatistics, TooFewValuesHaveNoFigure) {
  const SampleStatistics none = sampleStatistics({}), one = sampleStatistics({7});
  EXPECT_EQ(none.count, 0);
  for (const double figure : {none.mean, none.sd, none.median, none.p95, none.p99, none.max})
    EXPECT_TRUE(std::isnan(figure));
  EXPECT_EQ(one.mean, 7);
  EXPECT_EQ(one.p99, 7);
  EXPECT_TRUE(std::isnan(one.sd));
}

}  // namespace
}  // namespace falciform
