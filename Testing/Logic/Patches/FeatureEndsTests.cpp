#include "Logic/Patches/FeatureEnds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace falciform {
namespace {

/// A straight line of points 1 mm apart that looks the same all along.
TracedLine straightLine(Index count) {
  TracedLine line;
  line.points = Points::Zero(count, 3);
  for (Index i = 0; i < count; ++i) line.points(i, 0) = static_cast<double>(i);
  line.standard = line.points;
  line.logOdds = VectorXd::Zero(count);
  return line;
}

constexpr double kSizeMm = 50;

/// Learnt from ends at these points of a line of 300.
EndsModel learntFrom(const std::vector<LineEnds>& examples) {
  const TracedLine line = straightLine(300);
  std::vector<VectorXd> numbers;
  for (const LineEnds& ends : examples)
    numbers.push_back(endNumbers(line, line.points.leftCols(1) / kSizeMm, kSizeMm, ends));
  return fitEnds(numbers, std::vector<double>(examples.size(), 1.0));
}

TEST(FeatureEnds, LieInTheMiddleOfThoseLearnt) {
  const EndsModel model = learntFrom({{40, 200}, {50, 210}, {60, 220}, {50, 200}, {50, 220}});
  const TracedLine line = straightLine(300);
  const LineEnds ends = likelyEnds(line, line.points.leftCols(1) / kSizeMm, kSizeMm, model);
  EXPECT_NEAR(static_cast<double>(ends.first), 50, 3);  // ends are tried every 3 mm
  EXPECT_NEAR(static_cast<double>(ends.last), 210, 3);
}

TEST(FeatureEnds, FollowTheirPlacesRatherThanTheCountOfPoints) {
  const EndsModel model = learntFrom({{40, 200}, {50, 210}, {60, 220}, {50, 200}, {50, 220}});
  const TracedLine line = straightLine(280);  // begins 20 mm later than the lines learnt from
  const Eigen::MatrixXd places = (line.points.leftCols(1).array() + 20) / kSizeMm;
  const LineEnds ends = likelyEnds(line, places, kSizeMm, model);
  EXPECT_NEAR(static_cast<double>(ends.first), 30, 3);
  EXPECT_NEAR(static_cast<double>(ends.last), 190, 3);
}

TEST(FeatureEnds, AreThoseOfTheWholeLineIfItIsTooShortToChoose) {
  EndsModel model = learntFrom({{40, 200}, {60, 220}});
  model.shortestMm = 60;
  const TracedLine line = straightLine(50);
  const LineEnds ends = likelyEnds(line, line.points.leftCols(1) / kSizeMm, kSizeMm, model);
  EXPECT_EQ(ends.first, 0);
  EXPECT_EQ(ends.last, 49);
}

}  // namespace
}  // namespace falciform
