#include "Logic/Registration/Trials/Proportion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace falciform {
namespace {

/// P(X >= k) of n trials at chance p, summed term by term.
double upperTail(int k, int n, double p) {
  double sum = 0;
  for (int j = k; j <= n; ++j)
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(j + 1.0) - std::lgamma(n - j + 1.0) + j * std::log(p) +
                    (n - j) * std::log1p(-p));
  return sum;
}

TEST(Proportion, AllOfNProveWhatTheClosedFormSays) {
  // With no failure the one-sided bound is alpha^(1/n).
  for (const int n : {1, 2, 10, 250, 1000, 10000})
    EXPECT_NEAR(proportionInterval(n, n).atLeast, std::pow(0.05, 1.0 / n), 1e-12) << n;
  EXPECT_NEAR(proportionInterval(250, 250).atLeast, 0.988, 5e-4);       // the thesis's 250 of 250
  EXPECT_NEAR(proportionInterval(10000, 10000).atLeast, 0.9997, 5e-5);  // ten thousand of ten thousand
  EXPECT_EQ(proportionInterval(250, 250).high, 1);
  EXPECT_EQ(proportionInterval(0, 250).low, 0);
  EXPECT_EQ(proportionInterval(0, 250).atLeast, 0);
  EXPECT_NEAR(proportionInterval(0, 250).high, 1 - std::pow(0.025, 1.0 / 250), 1e-12);
}

TEST(Proportion, PrintedTablesAreMet) {
  // Fisher and Yates, Statistical Tables: 5 of 10 at 95 %, and 1 of 20. Four printed places.
  EXPECT_NEAR(proportionInterval(5, 10).low, 0.1871, 5e-5);
  EXPECT_NEAR(proportionInterval(5, 10).high, 0.8129, 5e-5);
  EXPECT_NEAR(proportionInterval(1, 20).low, 0.0013, 5e-5);
  EXPECT_NEAR(proportionInterval(1, 20).high, 0.2487, 5e-5);
}

TEST(Proportion, BoundsLeaveExactlyTheTailsOfTheBinomial) {
  for (int n = 1; n <= 40; ++n)
    for (int k = 0; k <= n; ++k) {
      const ProportionInterval interval = proportionInterval(k, n);
      // Sums of 40 terms and a root to machine precision: 1e-11 is generous.
      if (k > 0) {
        EXPECT_NEAR(upperTail(k, n, interval.low), 0.025, 1e-11) << k << " of " << n;
        EXPECT_NEAR(upperTail(k, n, interval.atLeast), 0.05, 1e-11) << k << " of " << n;
      }
      if (k < n) {
        EXPECT_NEAR(1 - upperTail(k + 1, n, interval.high), 0.025, 1e-11) << k << " of " << n;
      }
      EXPECT_LE(interval.low, interval.atLeast);
      EXPECT_LE(interval.atLeast, static_cast<double>(k) / n);
      EXPECT_GE(interval.high, static_cast<double>(k) / n);
    }
}

TEST(Proportion, HoldsForTenThousandTrialsToo) {
  for (const int k : {1, 37, 5000, 9990, 9999}) {
    const ProportionInterval interval = proportionInterval(k, 10000);
    // lgamma of 10^4 is good to 1e-11 of its value of 8e4.
    EXPECT_NEAR(upperTail(k, 10000, interval.low), 0.025, 1e-7) << k;
    EXPECT_NEAR(1 - upperTail(k + 1, 10000, interval.high), 0.025, 1e-7) << k;
  }
}

TEST(Proportion, NoTrialProvesNothing) {
  EXPECT_EQ(proportionInterval(0, 0).low, 0);
  EXPECT_EQ(proportionInterval(0, 0).high, 1);
}

}  // namespace
}  // namespace falciform
