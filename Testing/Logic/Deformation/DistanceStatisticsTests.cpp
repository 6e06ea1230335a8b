#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "Logic/Deformation/DistanceMapping.h"

namespace falciform {
namespace {

TEST(DistanceStatistics, EqualTheirTextbookFormulas) {
  VectorXd values(5);
  values << -3, 1, 2, -1, 6;
  const DistanceStatistics s = distanceStatistics(values);
  EXPECT_EQ(s.count, 5);
  EXPECT_DOUBLE_EQ(s.mean, 1);
  EXPECT_DOUBLE_EQ(s.sd, std::sqrt((16 + 0 + 1 + 4 + 25) / 4.0));  // n - 1
  EXPECT_DOUBLE_EQ(s.median, 1);
  EXPECT_DOUBLE_EQ(s.min, -3);
  EXPECT_DOUBLE_EQ(s.max, 6);
  EXPECT_DOUBLE_EQ(s.rms, std::sqrt(51 / 5.0));
  EXPECT_DOUBLE_EQ(s.meanAbsolute, 13 / 5.0);
  EXPECT_DOUBLE_EQ(s.p95Absolute, 3 + 0.8 * 3);                    // 1 1 2 3 6: place 0.95 * 4 = 3.8
  EXPECT_DOUBLE_EQ(distanceStatistics(values.head(4)).median, 0);  // between -1 and 1
}

TEST(DistanceStatistics, LeaveOutWhatHasNoValue) {
  std::mt19937 random(3);
  std::normal_distribution<double> draw(2, 4);
  VectorXd clean(301), holed(602);
  for (Index i = 0; i < clean.size(); ++i) {
    holed[2 * i] = clean[i] = draw(random);
    holed[2 * i + 1] = NAN;
  }
  const DistanceStatistics a = distanceStatistics(clean), b = distanceStatistics(holed);
  EXPECT_EQ(b.count, 301);
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.sd, b.sd);
  EXPECT_EQ(a.median, b.median);
  EXPECT_EQ(a.p95Absolute, b.p95Absolute);
  EXPECT_EQ(a.min, b.min);
  EXPECT_EQ(a.max, b.max);
  EXPECT_EQ(a.rms, b.rms);
  EXPECT_NEAR(a.rms * a.rms, a.mean * a.mean + a.sd * a.sd * 300 / 301,
              1e-9);  // mm^2: the same sum in another order
}

TEST(DistanceStatistics, OfNothingAreNoNumbersAndNeverZero) {
  for (const VectorXd& values : {VectorXd(0), VectorXd(VectorXd::Constant(4, NAN))}) {
    const DistanceStatistics s = distanceStatistics(values);
    EXPECT_EQ(s.count, 0);
    for (const double figure : {s.mean, s.sd, s.median, s.p95Absolute, s.min, s.max, s.rms, s.meanAbsolute})
      EXPECT_TRUE(std::isnan(figure));
  }
  const DistanceStatistics one = distanceStatistics(VectorXd::Constant(1, -2.5));
  EXPECT_EQ(one.mean, -2.5);
  EXPECT_EQ(one.median, -2.5);
  EXPECT_EQ(one.p95Absolute, 2.5);
  EXPECT_TRUE(std::isnan(one.sd)) << "one value has no spread";
}

}  // namespace
}  // namespace falciform
