#include "Logic/Patches/CrestLines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

/// A roof along x, 120 mm long: z = -slope(x) sqrt(y^2 + r^2), so that its top is y = 0 and as sharp as slope
/// / r. Rows are shifted against each other so that no edge runs along the top.
template <class Slope>
Surface roof(double r, const Slope& slope, double sign = 1) {
  constexpr int kAlong = 80, kAcross = 40;
  Surface surface;
  surface.points.resize((kAlong + 1) * (kAcross + 1), 3);
  surface.triangles.resize(2 * kAlong * kAcross, 3);
  Index f = 0;
  for (int i = 0; i <= kAlong; ++i)
    for (int j = 0; j <= kAcross; ++j) {
      const int v = i * (kAcross + 1) + j;
      const double x = 1.5 * i, y = 1.5 * (j - kAcross / 2) + 0.4 + 0.3 * (i % 2);
      surface.points.row(v) << x, y, -sign * slope(x) * std::sqrt(y * y + r * r);
      if (i == kAlong || j == kAcross) continue;
      surface.triangles.row(f++) << v, v + kAcross + 1, v + 1;
      surface.triangles.row(f++) << v + 1, v + kAcross + 1, v + kAcross + 2;
    }
  return surface;
}
double steep(double) { return 1; }

TEST(CrestLines, TheTopOfARoofIsOneRidgeAndNoValley) {
  const Surface surface = roof(4, steep);
  const std::vector<CrestLine> ridges = crestLines(surface, CrestKind::Ridge);
  ASSERT_THAT(ridges, testing::SizeIs(1));
  EXPECT_LT(ridges[0].points.col(1).cwiseAbs().maxCoeff(), 0.75);  // mm: half an edge
  EXPECT_GT(ridges[0].lengthMm, 100);  // of 120; curvature is not known at the border
  EXPECT_THAT(crestLines(surface, CrestKind::Valley), testing::IsEmpty());
}

TEST(CrestLines, ARidgeUpsideDownIsAValley) {
  const Surface surface = roof(4, steep, -1);
  EXPECT_THAT(crestLines(surface, CrestKind::Ridge), testing::IsEmpty());
  const std::vector<CrestLine> valleys = crestLines(surface, CrestKind::Valley);
  ASSERT_THAT(valleys, testing::SizeIs(1));
  EXPECT_LT(valleys[0].points.col(1).cwiseAbs().maxCoeff(), 0.75);
}

TEST(CrestLines, StrengthIsCurvatureTimesLength) {
  CrestLineSettings fine;
  fine.scaleMm = 3;
  const CrestLine line = crestLines(roof(10, steep), CrestKind::Ridge, fine).at(0);
  // 1 / 10 mm at the top; a fit over 3 mm takes in flatter places: -3 / 2 (y / r)^2 of it at y, a few per
  // cent.
  EXPECT_NEAR(line.strength / line.lengthMm, 0.1, 0.01);
}

TEST(CrestLines, AGapIsBridgedIfItIsShort) {
  // Flat for 9 mm in the middle: too blunt to go on there.
  const auto sagging = [](double x) { return std::abs(x - 60) < 4.5 ? 0.02 : 1.0; };
  CrestLineSettings settings;
  settings.scaleMm = 3;
  settings.gapMm = 20;
  const Surface surface = roof(3, sagging);
  const double longest = crestLines(surface, CrestKind::Ridge, settings).at(0).lengthMm;
  settings.gapMm = 0;
  EXPECT_GT(longest, 95);
  EXPECT_LT(crestLines(surface, CrestKind::Ridge, settings).at(0).lengthMm, 75);
}

TEST(CrestLines, BluntShapesHaveNone) {
  EXPECT_THAT(crestLines(roof(60, steep), CrestKind::Ridge), testing::IsEmpty());
}

TEST(CrestLines, HysteresisAsksForASharpPlaceSomewhere) {
  CrestLineSettings settings;
  settings.highPerMm = 1;  // nowhere on a roof of 4 mm
  EXPECT_THAT(crestLines(roof(4, steep), CrestKind::Ridge, settings), testing::IsEmpty());
}

TEST(CrestLines, RefuseACloud) {
  Surface cloud = roof(4, steep);
  cloud.triangles.resize(0, 3);
  EXPECT_THROW((void)crestLines(cloud, CrestKind::Ridge), InputError);
}

TEST(CrestCost, IsLowOnTheCrestAndOneOnTheFlat) {
  const Surface surface = roof(4, steep);
  const VectorXd cost = crestCost(surface, CrestKind::Ridge);
  for (Index i = 0; i < surface.size(); ++i) {
    if (surface.points(i, 0) < 20 || surface.points(i, 0) > 100) continue;
    const double aside = std::abs(surface.points(i, 1));
    if (aside < 0.6) {
      EXPECT_LT(cost[i], 0.5);
    }
    if (aside > 14 && aside < 20) {
      EXPECT_GT(cost[i], 0.9);
    }
  }
  EXPECT_THROW((void)crestCost(surface, CrestKind::Ridge, 0), InputError);
}

}  // namespace
}  // namespace falciform
