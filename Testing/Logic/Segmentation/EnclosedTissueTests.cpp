#include "Logic/Segmentation/EnclosedTissue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "Logic/Segmentation/LevelSet.h"
#include "Testing/Logic/Segmentation/PaintedCt.h"

namespace falciform {
namespace {

using test::paintedCt;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

constexpr double kOrganHu = 100, kFatHu = -90, kLungHu = -850, kMuscleHu = 55, kTumourHu = 50;
constexpr double kOrganMm = 40;
const Vector3d kMiddle(66, 66, 66);

double ballMl(double radius) { return 4.0 / 3 * std::numbers::pi * radius * radius * radius / 1000; }

struct Ball {
  Vector3d at;
  double radiusMm = 0, hu = 0;
};

/// An organ of 40 mm radius with balls painted over it and what surrounds both.
Image organCt(const std::vector<Ball>& balls, double aroundHu, double noiseHu = 0) {
  return paintedCt({44, 44, 44}, {3, 3, 3}, noiseHu, 11, [&](const Vector3d& at) {
    double hu = (at - kMiddle).norm() < kOrganMm ? kOrganHu : aroundHu;
    for (const Ball& ball : balls)
      if ((at - ball.at).norm() < ball.radiusMm) hu = ball.hu;
    return hu;
  });
}

Vector3d beside(double mm) { return kMiddle + Vector3d(mm, 0, 0); }

/// The organ as a first growth leaves it: all of its own brightness.
std::vector<EnclosedBody> bodiesIn(const Image& ct) {
  Volume<std::uint8_t> organ{ct.size, ct.worldFromIndex, {}};
  for (const float hu : ct.voxels) organ.voxels.push_back(hu == static_cast<float>(kOrganHu));
  return enclosedBodies(ct, organ, {}, {});
}

TEST(EnclosedTissue, TumourThatReachesTheBorderIsFound) {
  const std::vector<EnclosedBody> bodies = bodiesIn(organCt({{beside(28), 14, kTumourHu}}, kFatHu));
  ASSERT_THAT(bodies, SizeIs(1));
  EXPECT_NEAR(bodies[0].volumeMl, ballMl(14), 0.15 * ballMl(14));  // a third of a voxel of the radius
  EXPECT_EQ(bodies[0].tissue.level, kTumourHu);
  EXPECT_GT(bodies[0].enclosedShare, 0.8);
  EXPECT_LT((bodies[0].place - beside(28)).norm(), 5);  // its deepest place, to a voxel's diagonal
}

TEST(EnclosedTissue, NeighbourInADentIsNoPartOfTheOrgan) {
  // A stomach that presses 10 mm deep into the organ: a third of its border at most.
  EXPECT_THAT(bodiesIn(organCt({{beside(50), 20, kTumourHu}}, kFatHu)), IsEmpty());
}

TEST(EnclosedTissue, WaterIsNeverTakenIn) {
  // A gallbladder deep in its bed, and a cyst.
  EXPECT_THAT(bodiesIn(organCt({{beside(28), 14, 8}}, kFatHu)), IsEmpty());
}

TEST(EnclosedTissue, TumourIsPartedFromTheMuscleItTouches) {
  // The rim over it is thinner than a voxel: through the hole it hangs together with muscle of nearly its own
  // brightness, which is all there is outside.
  const std::vector<EnclosedBody> bodies = bodiesIn(organCt({{beside(26.5), 14, kTumourHu}}, kMuscleHu));
  ASSERT_THAT(bodies, SizeIs(1));
  EXPECT_LT(bodies[0].volumeMl, 1.2 * ballMl(14));
  EXPECT_GT(bodies[0].volumeMl, 0.5 * ballMl(14));
}

TEST(EnclosedTissue, MuscleAllAroundIsNotTakenIn) {
  EXPECT_THAT(bodiesIn(organCt({}, kMuscleHu)), IsEmpty());
}

TEST(EnclosedTissue, BodyLessThanHalfSunkenIsTheOrgansAtTheLungOnly) {
  const std::vector<Ball> half{{beside(42), 14, kTumourHu}};
  EXPECT_THAT(bodiesIn(organCt(half, kLungHu)), SizeIs(1));
  EXPECT_THAT(bodiesIn(organCt(half, kFatHu)), IsEmpty());
}

TEST(EnclosedTissue, HeartOnTheDomeIsNotTakenIn) {
  // It lies on the organ with a fifth of its border, and the lung is around the rest.
  EXPECT_THAT(bodiesIn(organCt({{beside(54), 20, 45}}, kLungHu)), IsEmpty());
}

TEST(EnclosedTissue, NothingIsTakenWhereItIsForbidden) {
  const Image ct = organCt({{beside(28), 14, kTumourHu}}, kFatHu);
  Volume<std::uint8_t> organ{ct.size, ct.worldFromIndex, {}}, barred = organ;
  for (const float hu : ct.voxels) {
    organ.voxels.push_back(hu == static_cast<float>(kOrganHu));
    barred.voxels.push_back(hu == static_cast<float>(kTumourHu));
  }
  EXPECT_THAT(enclosedBodies(ct, organ, barred, {}), IsEmpty());
}

LevelSetResult grown(const Image& ct, bool takeEnclosed = true) {
  LevelSetSettings settings;
  settings.leastVolumeMl = 0;  // the phantoms are smaller than livers
  settings.takeEnclosed = takeEnclosed;
  return segmentLevelSet({.ct = ct, .seeds = Points((kMiddle - Vector3d(15, 0, 0)).transpose())}, settings);
}

TEST(LevelSetEnclosed, TumourAtTheBorderIsTakenInAndTold) {
  const Image ct = organCt({{beside(28), 14, kTumourHu}}, kFatHu, 15);
  const LevelSetResult with = grown(ct), without = grown(ct, false);
  const double whole = ballMl(kOrganMm);
  EXPECT_NEAR(with.volumeMl, whole, 0.04 * whole);  // half a millimetre of the radius: a sixth of a voxel
  EXPECT_LT(without.volumeMl, whole - 0.5 * ballMl(14));
  EXPECT_THAT(with.enclosed, SizeIs(1));
  EXPECT_THAT(with.warnings, Contains(HasSubstr("was taken in")));
  EXPECT_THAT(without.enclosed, IsEmpty());
  EXPECT_THAT(without.warnings, Not(Contains(HasSubstr("was taken in"))));
}

TEST(LevelSetEnclosed, StomachBesideTheOrganStaysOutside) {
  const Image ct = organCt({{beside(50), 20, kTumourHu}}, kFatHu, 15);
  const LevelSetResult result = grown(ct);
  std::size_t inside = 0;
  for (int k = 0; k < ct.size.z(); ++k)
    for (int j = 0; j < ct.size.y(); ++j)
      for (int i = 0; i < ct.size.x(); ++i)
        inside += result.labels.at(i, j, k) > 0 && (ct.world(Vector3d(i, j, k)) - beside(50)).norm() < 17;
  // Its border may be missed by a voxel; farther in nothing is organ.
  EXPECT_EQ(inside, 0u);
  EXPECT_THAT(result.enclosed, IsEmpty());
}

TEST(LevelSetEnclosed, BrightVesselAcrossTheOrganIsFilled) {
  const Image ct = paintedCt({44, 44, 44}, {3, 3, 3}, 15, 12, [](const Vector3d& at) {
    const Vector3d from = at - kMiddle;
    if (from.norm() >= kOrganMm) return kFatHu;
    return std::hypot(from.x() - 8, from.y()) < 4.5 ? 180.0 : kOrganHu;
  });
  const double whole = ballMl(kOrganMm);
  EXPECT_NEAR(grown(ct).volumeMl, whole, 0.04 * whole);
}

}  // namespace
}  // namespace falciform
