#include "Logic/Segmentation/LevelSet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Testing/Logic/Segmentation/PaintedCt.h"

namespace falciform {
namespace {

using test::dice;
using test::paintedCt;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr double kOrganHu = 100, kFatHu = -90;
const Vector3d kMiddle(60, 60, 60);

Points seedsAt(std::initializer_list<Vector3d> places) {
  Points seeds(static_cast<Index>(places.size()), 3);
  Index row = 0;
  for (const Vector3d& place : places) seeds.row(row++) = place.transpose();
  return seeds;
}

/// The phantoms are smaller than livers.
LevelSetSettings smallOrgan() {
  LevelSetSettings settings;
  settings.leastVolumeMl = 0;
  return settings;
}

double ballMl(double radius) { return 4.0 / 3 * std::numbers::pi * radius * radius * radius / 1000; }

/// A ball of 35 mm in fat, 1.5 x 1.5 x 2 mm voxels, noise of 25 HU, as an abdominal CT has.
Image ballCt(const std::function<double(const Vector3d&, double)>& more = [](const Vector3d&, double hu) {
  return hu;
}) {
  return paintedCt({80, 80, 60}, {1.5, 1.5, 2}, 25, 1, [&](const Vector3d& at) {
    return more(at, (at - kMiddle).norm() < 35 ? kOrganHu : kFatHu);
  });
}

TEST(LevelSet, BallInNoiseGrowsToItsVolume) {
  const LevelSetResult result =
      segmentLevelSet({.ct = ballCt(), .seeds = seedsAt({{50, 65, 55}})}, smallOrgan());
  // 3 % of the volume is 0.35 mm of the radius: a quarter of a voxel.
  EXPECT_NEAR(result.volumeMl, ballMl(35), 0.03 * ballMl(35));
  EXPECT_NEAR(result.tissueLevelHu, kOrganHu, 2);  // of thousands of voxels
  EXPECT_LT(result.weakBorderShare, 0.02);         // 190 HU are an edge everywhere
  EXPECT_THAT(result.warnings, testing::IsEmpty());
}

TEST(LevelSet, SeedsPlaceInTheOrganDoesNotMatter) {
  const Image ct = ballCt();
  const LevelSetResult a = segmentLevelSet({.ct = ct, .seeds = seedsAt({{60, 60, 60}})}, smallOrgan()),
                       b = segmentLevelSet({.ct = ct, .seeds = seedsAt({{75, 45, 70}, {40, 70, 60}})},
                                           smallOrgan());
  EXPECT_GT(dice(a.labels, b.labels), 0.99);
}

/// A second ball beside the first, joined by a rod.
Image twoBalls(double rodMm) {
  return paintedCt({120, 60, 60}, {2, 2, 2}, 15, 2, [&](const Vector3d& at) {
    const Vector3d a(60, 60, 60), b(160, 60, 60);
    const bool rod = at.x() > 60 && at.x() < 160 && std::hypot(at.y() - 60, at.z() - 60) < rodMm;
    return (at - a).norm() < 35 || (at - b).norm() < 30 || rod ? kOrganHu : kFatHu;
  });
}

TEST(LevelSet, StopsAtANarrowBridgeAndSaysSo) {
  const LevelSetResult result =
      segmentLevelSet({.ct = twoBalls(8), .seeds = seedsAt({{60, 60, 60}})}, smallOrgan());
  EXPECT_NEAR(result.volumeMl, ballMl(35), 0.08 * ballMl(35));  // and a stump of the rod
  ASSERT_FALSE(result.leftOut.empty());
  EXPECT_GT(result.leftOut[0].volumeMl, 0.7 * ballMl(30));
  EXPECT_GT(result.leftOut[0].place.x(), 120);  // beyond the rod's middle
  EXPECT_THAT(result.warnings, Contains(HasSubstr("stopped at narrow necks")));
}

TEST(LevelSet, LeakThroughABridgeIsWarnedOf) {
  LevelSetSettings settings = smallOrgan();
  settings.neckMm = 4;  // the user lets the front through
  const LevelSetResult result =
      segmentLevelSet({.ct = twoBalls(8), .seeds = seedsAt({{60, 60, 60}})}, settings);
  ASSERT_GT(result.volumeMl, 0.9 * (ballMl(35) + ballMl(30)));
  EXPECT_THAT(result.warnings, Contains(HasSubstr("narrow bridge")));
}

TEST(LevelSet, SeedBeyondTheBridgeTakesTheOtherPartIn) {
  const LevelSetResult result =
      segmentLevelSet({.ct = twoBalls(8), .seeds = seedsAt({{60, 60, 60}, {165, 55, 60}})}, smallOrgan());
  EXPECT_NEAR(result.volumeMl, ballMl(35) + ballMl(30), 0.08 * (ballMl(35) + ballMl(30)));
}

TEST(LevelSet, OrganCutOffByTheBorderIsWarnedOf) {
  const Image ct = paintedCt({60, 60, 40}, {2, 2, 2}, 10, 3, [](const Vector3d& at) {
    return (at - Vector3d(60, 60, 75)).norm() < 35 ? kOrganHu : kFatHu;
  });
  const LevelSetResult result = segmentLevelSet({.ct = ct, .seeds = seedsAt({{60, 60, 60}})}, smallOrgan());
  EXPECT_THAT(result.warnings, Contains(HasSubstr("border (top)")));
  EXPECT_GT(result.labels.at(30, 30, 39), 0);  // up to the last slice
}

TEST(LevelSet, VolumeNoLiverHasIsWarnedOf) {
  LevelSetSettings settings;
  settings.leastVolumeMl = 500;
  const Image ct = ballCt();
  EXPECT_THAT(segmentLevelSet({.ct = ct, .seeds = seedsAt({kMiddle})}, settings).warnings,
              Contains(HasSubstr("less than the 500 ml expected")));
  settings = smallOrgan();
  settings.mostVolumeMl = 100;
  EXPECT_THAT(segmentLevelSet({.ct = ct, .seeds = seedsAt({kMiddle})}, settings).warnings,
              Contains(HasSubstr("more than the 100 ml expected")));
}

TEST(LevelSet, TumourIsTakenInByASeedOfItsOwn) {
  const Vector3d tumour(83, 60, 60);  // at the border: no cavity that would be filled anyway
  const Image ct =
      ballCt([&](const Vector3d& at, double hu) { return hu > 0 && (at - tumour).norm() < 12 ? 30 : hu; });
  LevelSetSettings settings = smallOrgan();
  settings.takeEnclosed = false;
  const LevelSetResult without = segmentLevelSet({.ct = ct, .seeds = seedsAt({{45, 60, 60}})}, settings),
                       with = segmentLevelSet({.ct = ct, .seeds = seedsAt({{45, 60, 60}, tumour})}, settings);
  EXPECT_LT(without.volumeMl, ballMl(35) - 0.4 * ballMl(12));
  EXPECT_NEAR(with.volumeMl, ballMl(35), 0.03 * ballMl(35));
  EXPECT_THAT(with.warnings, Contains(HasSubstr("unlike the organ's")));
}

}  // namespace
}  // namespace falciform
