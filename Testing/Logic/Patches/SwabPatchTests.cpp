#include "Logic/Patches/SwabPatch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/KdTree.h"

namespace falciform {
namespace {

/// 120 x 60 mm with 2 mm squares in the plane z = 0.
Surface plane() {
  Surface surface;
  surface.points.resize(61 * 31, 3);
  surface.triangles.resize(2 * 60 * 30, 3);
  Index f = 0;
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 30; ++j) {
      const int v = i * 31 + j;
      surface.points.row(v) << 2 * i, 2 * j, 0;
      if (i == 60 || j == 30) continue;
      surface.triangles.row(f++) << v, v + 31, v + 1;
      surface.triangles.row(f++) << v + 1, v + 31, v + 32;
    }
  return surface;
}

/// A way along y = 30 from x = 20 to 100, every 4 mm, with the tip's noise of 1 mm.
TrackedPoints swabAlong(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 1);
  TrackedPoints swab;
  swab.points.resize(21, 3);
  for (Index i = 0; i < 21; ++i)
    swab.points.row(i) << 20 + 4 * static_cast<double>(i) + noise(random), 30 + noise(random), noise(random);
  swab.stroke.assign(21, 0);
  return swab;
}

/// Vertices within half of `widthMm` of the true way.
std::vector<int> truth(const Surface& surface, double widthMm) {
  std::vector<int> found;
  for (Index i = 0; i < surface.size(); ++i) {
    const double along = std::clamp(surface.points(i, 0), 20.0, 100.0);
    if (std::hypot(surface.points(i, 0) - along, surface.points(i, 1) - 30) <= widthMm / 2)
      found.push_back(static_cast<int>(i));
  }
  return found;
}

double dice(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return 2.0 * static_cast<double>(both.size()) / static_cast<double>(a.size() + b.size());
}

TEST(SwabPatch, PaintsTheWayOfTheTip) {
  const Surface surface = plane();
  const SwabPatch patch = patchOfSwab(surface, swabAlong(1));
  // A band of 10 mm whose borders are off by the noise of 1 mm: a tenth of it each way.
  EXPECT_GT(dice(patch.vertices, truth(surface, 10)), 0.85);
  EXPECT_EQ(patch.used, 21);
  EXPECT_NEAR(patch.lengthMm, 80, 8);  // noise makes the way longer
  EXPECT_THAT(patch.warnings, testing::IsEmpty());
}

TEST(SwabPatch, LeavesOutWhereTheTipWasLifted) {
  const Surface surface = plane();
  TrackedPoints swab = swabAlong(2);
  for (Index i = 8; i < 12; ++i) swab.points(i, 2) += 30;  // x = 52 to 64
  const SwabPatch patch = patchOfSwab(surface, swab);
  EXPECT_EQ(patch.liftedOff, 4);
  // 20 mm between the points around the lift: below the longest gap, so the way is joined over it.
  EXPECT_GT(dice(patch.vertices, truth(surface, 10)), 0.85);
  SwabSettings strict;
  strict.gapMm = 10;
  const SwabPatch open = patchOfSwab(surface, swab, strict);
  const int middle = 29 * 31 + 15;  // (58, 30)
  EXPECT_TRUE(std::binary_search(patch.vertices.begin(), patch.vertices.end(), middle));
  EXPECT_FALSE(std::binary_search(open.vertices.begin(), open.vertices.end(), middle));
}

TEST(SwabPatch, LeavesOutOutliers) {
  const Surface surface = plane();
  TrackedPoints swab = swabAlong(3);
  swab.points(10, 1) = 5;  // on the surface, 25 mm aside
  const SwabPatch patch = patchOfSwab(surface, swab);
  EXPECT_EQ(patch.outliers, 1);
  EXPECT_GT(dice(patch.vertices, truth(surface, 10)), 0.85);
}

TEST(SwabPatch, DoesNotJoinStrokes) {
  const Surface surface = plane();
  TrackedPoints swab;
  swab.points.resize(6, 3);
  swab.points << 20, 10, 0, 24, 10, 0, 28, 10, 0, 20, 26, 0, 24, 26, 0, 28, 26, 0;
  swab.stroke = {0, 0, 0, 1, 1, 1};
  const SwabPatch patch = patchOfSwab(surface, swab);
  for (const int v : patch.vertices) EXPECT_GT(std::abs(surface.points(v, 1) - 18), 2.9);
  EXPECT_NEAR(patch.lengthMm, 16, 1e-9);
}

TEST(SwabPatch, WorksOnACloud) {
  Surface cloud = plane();
  cloud.triangles.resize(0, 3);
  EXPECT_GT(dice(patchOfSwab(cloud, swabAlong(4)).vertices, truth(cloud, 10)), 0.8);
}

TEST(SwabPatch, RefusesASwabElsewhere) {
  TrackedPoints swab = swabAlong(5);
  swab.points.col(2).array() += 500;
  EXPECT_THROW((void)patchOfSwab(plane(), swab), InputError);
}

}  // namespace
}  // namespace falciform
