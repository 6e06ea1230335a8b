#include "Logic/Core/Progress.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace falciform {

namespace {

struct Recorder {
  std::vector<double> fractions;
  std::vector<std::string> stages;
  std::stop_source stop;

  Progress progress() {
    return Progress(
        [this](double fraction, std::string_view stage) {
          fractions.push_back(fraction);
          stages.emplace_back(stage);
        },
        stop.get_token());
  }
};

}  // namespace

TEST(Progress, DefaultIsSilentAndNeverCancelled) {
  const Progress silent;
  EXPECT_NO_THROW(silent.report(0.5, "anything"));
  EXPECT_FALSE(silent.stopRequested());
}

TEST(Progress, PartsOfPartsMapIntoTheWhole) {
  Recorder recorder;
  const Progress whole = recorder.progress(), part = whole.part(0.2, 0.6), inner = part.part(0.5, 1.0);
  whole.report(0.1, "a");
  part.report(0.5);
  inner.report(0);
  inner.report(0.5);
  inner.report(1);
  part.report(1);
  whole.report(1, "z");
  const double expected[] = {0.1, 0.4, 0.4, 0.5, 0.6, 0.6, 1.0};
  ASSERT_EQ(recorder.fractions.size(), std::size(expected));
  for (std::size_t i = 0; i < std::size(expected); ++i)
    EXPECT_NEAR(recorder.fractions[i], expected[i], 1e-15) << i;  // two roundings of numbers below 1
  EXPECT_EQ(recorder.stages.front(), "a");
  EXPECT_EQ(recorder.stages.back(), "z");
}

TEST(Progress, AStopIsThrownFromEveryPartAndNothingIsReportedAfterIt) {
  Recorder recorder;
  const Progress whole = recorder.progress(), part = whole.part(0.5, 0.7);
  part.report(0);
  recorder.stop.request_stop();
  EXPECT_TRUE(part.stopRequested());
  EXPECT_THROW(part.report(0.5), Cancelled);
  EXPECT_THROW(whole.report(0.9), Cancelled);
  EXPECT_EQ(recorder.fractions.size(), 1U);
}

}  // namespace falciform
