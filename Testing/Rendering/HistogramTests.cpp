#include "Widgets/Rendering/Histogram.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <random>

namespace falciform {

TEST(Histogram, CountsEachFiniteValueOnce) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.5, 3);
  VectorXd values(1000);
  for (double& value : values) value = normal(random);
  values[10] = std::numeric_limits<double>::quiet_NaN();
  values[11] = std::numeric_limits<double>::infinity();
  const Histogram histogram = histogramOf(values, -10, 10, 0.5);
  ASSERT_EQ(histogram.shares.size(), 40u);
  EXPECT_NEAR(std::accumulate(histogram.shares.begin(), histogram.shares.end(), 0.0), 1, 1e-12);
  for (std::size_t bin = 1; bin + 1 < histogram.shares.size(); ++bin) {
    const double low = -10 + 0.5 * static_cast<double>(bin);
    int count = 0;
    for (const double value : values) count += value >= low && value < low + 0.5;
    EXPECT_NEAR(histogram.shares[bin], count / 998.0, 1e-12) << "bin from " << low;
  }
}

TEST(Histogram, OfNothingIsEmptyButHasBins) {
  const Histogram histogram = histogramOf(VectorXd(), -1, 1, 0.5);
  EXPECT_EQ(histogram.shares, std::vector<double>(4, 0.0));
}

TEST(Histogram, BinsAreRound) {
  EXPECT_DOUBLE_EQ(binWidth(-10, 10), 0.5);
  EXPECT_DOUBLE_EQ(binWidth(-5, 5), 0.5);
  EXPECT_DOUBLE_EQ(binWidth(-1, 1), 0.05);
  EXPECT_DOUBLE_EQ(binWidth(3, 3), 1) << "an empty range";
}

}  // namespace falciform
