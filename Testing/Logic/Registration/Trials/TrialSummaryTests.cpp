#include "Logic/Registration/Trials/TrialSummary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace falciform {
namespace {

TrialRecord record(int method, bool success, double rmsMm, double tre, int warnings, double seconds,
                   int iterations) {
  TrialRecord made;
  made.method = method;
  made.success = success;
  made.rmsMm = rmsMm;
  made.targetErrorMm = tre;
  made.goldDistanceMm = 2 * tre;
  made.warnings = warnings;
  made.seconds = seconds;
  made.iterations = iterations;
  return made;
}

const std::vector<TrialRecord> kRecords{
    record(0, true, 1, 2, 0, 0.2, 10),  record(0, true, 3, 3, 1, 0.4, 10), record(0, false, 5, 100, 2, 9, 3),
    record(0, false, 7, 50, 0, 9, 100), record(1, true, 1, 1, 0, 1, 1),
};
const std::vector<int> kBasins{1, 1, 2, 3, 1};

TEST(TrialSummary, CountsAndAveragesOneMethodAlone) {
  const TrialSummary s = summarise(kRecords, kBasins, 0, {});
  EXPECT_EQ(s.trials, 4);
  EXPECT_EQ(s.successes, 2);
  EXPECT_EQ(s.success.low, proportionInterval(2, 4).low);
  EXPECT_DOUBLE_EQ(s.rmsMm.mean, 4);
  EXPECT_DOUBLE_EQ(s.rmsOfSuccessesMm.mean, 2);
  EXPECT_DOUBLE_EQ(s.targetErrorMm.mean, 38.75);
  EXPECT_DOUBLE_EQ(s.targetErrorOfSuccessesMm.mean, 2.5);
  EXPECT_NEAR(s.secondsOfSuccesses.mean, 0.3, 1e-15);
  EXPECT_NEAR(s.secondsPerIterationOfSuccesses.mean, 0.03, 1e-15);
  EXPECT_EQ(s.nearGold, 1);  // 2 x 2 mm; the other success lies 6 mm off at its farthest vertex
  EXPECT_EQ(s.failuresFlagged, 1);
  EXPECT_EQ(s.successesFlagged, 1);
  EXPECT_EQ(s.basins, 3);
  EXPECT_EQ(s.inLargestBasin, 2);
}

TEST(TrialSummary, WithoutTargetsOrSuccessesThereIsNoFigure) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const TrialSummary s = summarise({record(0, false, 9, none, 0, 1, 1)}, {1}, 0, {});
  EXPECT_TRUE(std::isnan(s.targetErrorMm.mean));
  EXPECT_TRUE(std::isnan(s.rmsOfSuccessesMm.mean));
  EXPECT_EQ(s.successes, 0);
}

TEST(TrialSummary, ResultsThatAreOneToRoundingAreSaidToBeAlike) {
  const auto alike = [](double rmsMm, double tre) {
    return summarise({record(0, true, 1, 2, 0, 1, 1), record(0, true, rmsMm, tre, 0, 2, 1)}, {1, 1}, 0, {})
        .alike;
  };
  EXPECT_TRUE(alike(1 + 1e-9, 2 - 1e-9));
  EXPECT_FALSE(alike(1 + 1e-4, 2));
  EXPECT_FALSE(alike(1, 2.001));
  EXPECT_FALSE(
      summarise({record(0, true, 1, 2, 0, 1, 1)}, {1}, 0, {}).alike);  // one trial alone says nothing
}

}  // namespace
}  // namespace falciform
