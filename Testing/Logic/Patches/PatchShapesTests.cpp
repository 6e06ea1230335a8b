#include "Logic/Patches/PatchShapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using testing::ElementsAreArray;
using testing::IsEmpty;
using testing::IsSubsetOf;

constexpr int kMine = 1, kOther = 2;

/// Labels of a surface's points where `inside` holds.
template <class Inside>
std::vector<int> labelled(const Surface& surface, Inside inside) {
  std::vector<int> labels(static_cast<std::size_t>(surface.size()), 0);
  for (Index i = 0; i < surface.size(); ++i)
    if (inside(Vector3d(surface.points.row(i)))) labels[static_cast<std::size_t>(i)] = kMine;
  return labels;
}

std::vector<int> membersOf(const std::vector<int>& labels, int label = kMine) {
  std::vector<int> ids;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == label) ids.push_back(static_cast<int>(i));
  return ids;
}

std::vector<int> after(const std::vector<int>& labels, const PatchChange& change) {
  std::vector<int> result = labels;
  for (const int id : change.gained) result[static_cast<std::size_t>(id)] = kMine;
  for (const int id : change.lost) result[static_cast<std::size_t>(id)] = 0;
  return result;
}

double distanceTo(const Surface& surface, int id, const std::vector<int>& others) {
  double nearest = 1e9;
  for (const int other : others)
    nearest = std::min(nearest, (surface.points.row(id) - surface.points.row(other)).norm());
  return nearest;
}

Surface cloudOf(Surface mesh) {
  mesh.triangles.resize(0, 3);
  return mesh;
}

bool inDisc(const Vector3d& p) { return (p - Vector3d(20, 20, 0)).norm() <= 9.3; }

TEST(PatchShapes, GrowAndShrinkMoveTheBorderByTheDistanceAskedFor) {
  const Surface plane = test::grid(40, 80);  // edges 0.5 mm
  const std::vector<int> labels = labelled(plane, inDisc);
  const std::vector<int> mine = membersOf(labels), outside = membersOf(labels, 0);
  const PatchChange grown = grownPatch(BrushSurface(plane), labels, kMine, 4);
  const PatchChange shrunk = shrunkPatch(BrushSurface(plane), labels, kMine, 4);
  EXPECT_THAT(grown.lost, IsEmpty());
  EXPECT_THAT(shrunk.gained, IsEmpty());
  const std::set<int> gained(grown.gained.begin(), grown.gained.end()),
      lost(shrunk.lost.begin(), shrunk.lost.end());
  // By brute force: on a plane ways are straight. Beside the seeds a way begins along an edge, so that it may
  // come out longer, by less than an edge of 0.7 mm.
  for (Index i = 0; i < plane.size(); ++i) {
    const int id = static_cast<int>(i);
    if (labels[static_cast<std::size_t>(i)] == 0) {
      const double far = distanceTo(plane, id, mine);
      if (far <= 3.3) {
        EXPECT_TRUE(gained.count(id)) << far;
      }
      if (far > 4.06) {
        EXPECT_FALSE(gained.count(id)) << far;
      }
    } else {
      const double far = distanceTo(plane, id, outside);
      if (far <= 3.3) {
        EXPECT_TRUE(lost.count(id)) << far;
      }
      if (far > 4.06) {
        EXPECT_FALSE(lost.count(id)) << far;
      }
    }
  }
}

TEST(PatchShapes, OnACloudGrowAndShrinkAreWithinTheStraightDistance) {
  const Surface cloud = cloudOf(test::grid(40, 40));
  const std::vector<int> labels = labelled(cloud, inDisc);
  const PatchChange grown = grownPatch(BrushSurface(cloud), labels, kMine, 3.5);
  std::vector<int> expected;
  for (const int id : membersOf(labels, 0))
    if (distanceTo(cloud, id, membersOf(labels)) <= 3.5) expected.push_back(id);
  EXPECT_THAT(grown.gained, ElementsAreArray(expected));
}

TEST(PatchShapes, GrowingGoesAlongTheSurfaceNotThroughTheAir) {
  // A hairpin: two sheets 2 mm apart, joined at x = 0. A patch on the upper one must not reach the lower one
  // through the gap.
  Surface hairpin = test::grid(40, 80);
  for (Index i = 0; i < hairpin.size(); ++i) {
    const double x = hairpin.points(i, 0) - 20;
    hairpin.points(i, 0) = std::abs(x);
    hairpin.points(i, 2) = x < 0 ? 0 : 2 * std::min(1.0, x);
  }
  const std::vector<int> labels = labelled(
      hairpin, [](const Vector3d& p) { return p.z() > 1.9 && (p - Vector3d(14, 20, 2)).norm() < 3; });
  const PatchChange grown = grownPatch(BrushSurface(hairpin), labels, kMine, 5);
  EXPECT_GT(grown.gained.size(), 100U);
  for (const int id : grown.gained) EXPECT_GT(hairpin.points(id, 2), 1.9);
}

TEST(PatchShapes, AnOpenBorderIsNoOutsideForShrinking) {
  const Surface plane = test::grid(20, 20);
  const std::vector<int> all(static_cast<std::size_t>(plane.size()), kMine);
  EXPECT_TRUE(shrunkPatch(BrushSurface(plane), all, kMine, 3).empty());
}

TEST(PatchShapes, SmoothingKeepsAStraightBorderAndTheArea) {
  const Surface plane = test::grid(40, 40);
  const BrushSurface surface(plane);
  const std::vector<int> half = labelled(plane, [](const Vector3d& p) { return p.x() <= 20; });
  EXPECT_TRUE(smoothedPatch(surface, half, kMine, 2).empty());
}

TEST(PatchShapes, SmoothingTakesARaggedBorderBackToTheDiscItWas) {
  const Surface plane = test::grid(40, 80);
  const BrushSurface surface(plane);
  std::mt19937 random(5);
  std::vector<int> ragged = labelled(plane, inDisc);
  // Every second point within 1.5 mm of the border has the wrong label.
  for (Index i = 0; i < plane.size(); ++i) {
    const double far = (Vector3d(plane.points.row(i)) - Vector3d(20, 20, 0)).norm() - 9.3;
    if (std::abs(far) < 1.5 && random() % 2 == 0) {
      int& label = ragged[static_cast<std::size_t>(i)];
      label = kMine - label;
    }
  }
  const std::vector<int> smooth = after(ragged, smoothedPatch(surface, ragged, kMine, 2));
  double before = 0, now = 0;
  int wrongBefore = 0, wrongNow = 0;
  const std::vector<int> truth = labelled(plane, inDisc);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    before += ragged[i] * surface.weights()[static_cast<Index>(i)];
    now += smooth[i] * surface.weights()[static_cast<Index>(i)];
    wrongBefore += ragged[i] != truth[i];
    wrongNow += smooth[i] != truth[i];
  }
  EXPECT_NEAR(now, before, 0.25) << "mm^2: the area of one point";
  EXPECT_LT(wrongNow, 0.25 * wrongBefore);
  EXPECT_TRUE(largestPieceOfPatch(surface, smooth, kMine).empty()) << "no specks";
  EXPECT_TRUE(filledHoles(surface, smooth, kMine).empty()) << "no holes";
}

TEST(PatchShapes, TheLargestPieceIsByAreaNotByPoints) {
  // A fine patch of many points and small area beside a coarse one.
  Surface plane = test::grid(40, 40);
  for (Index i = 0; i < plane.size(); ++i)
    if (plane.points(i, 0) > 20) plane.points(i, 0) = 20 + 0.1 * (plane.points(i, 0) - 20);
  const auto fine = [](const Vector3d& p) { return p.x() > 20.5 && p.y() <= 20; };
  const auto coarse = [](const Vector3d& p) { return p.x() <= 10 && p.y() > 10 && p.y() < 30; };
  const std::vector<int> labels = labelled(plane, [&](const Vector3d& p) { return fine(p) || coarse(p); });
  const PatchChange change = largestPieceOfPatch(BrushSurface(plane), labels, kMine);
  EXPECT_THAT(change.lost, ElementsAreArray(membersOf(labelled(plane, fine))));
  EXPECT_GT(change.lost.size(), membersOf(labelled(plane, coarse)).size());
}

TEST(PatchShapes, HolesAreFilledButNeitherTheOtherSideNorABay) {
  const Surface body = test::sphere(50, 5);
  const BrushSurface surface(body);
  // A band all around, with a hole of 6 mm radius in it.
  const auto band = [](const Vector3d& p) { return std::abs(p.z()) < 12; };
  const auto hole = [](const Vector3d& p) { return (p - Vector3d(50, 0, 0)).norm() < 6; };
  const std::vector<int> labels = labelled(body, [&](const Vector3d& p) { return band(p) && !hole(p); });
  EXPECT_THAT(filledHoles(surface, labels, kMine).gained, ElementsAreArray(membersOf(labelled(body, hole))));
  // On an open sheet a bare corner that a patch cuts off is no hole.
  const Surface plane = test::grid(20, 20);
  const std::vector<int> cut = labelled(plane, [](const Vector3d& p) { return p.x() + p.y() > 3; });
  EXPECT_TRUE(filledHoles(BrushSurface(plane), cut, kMine).empty());
}

TEST(PatchShapes, ARegionEndsWhereLabelsDo) {
  const Surface plane = test::grid(20, 20);
  const BrushSurface surface(plane);
  std::vector<int> labels = labelled(plane, [](const Vector3d& p) {
    const double far = (p - Vector3d(10, 10, 0)).norm();
    return far > 5 && far < 7;
  });
  const auto at = [](int x, int y) { return y * 21 + x; };
  ASSERT_EQ(Vector3d(plane.points.row(at(10, 9))), Vector3d(10, 9, 0));
  const std::vector<int> inside = regionAt(surface, labels, at(10, 9));
  std::vector<int> expected;
  for (Index i = 0; i < plane.size(); ++i)
    if ((Vector3d(plane.points.row(i)) - Vector3d(10, 10, 0)).norm() <= 5)
      expected.push_back(static_cast<int>(i));
  EXPECT_THAT(inside, ElementsAreArray(expected));
  EXPECT_EQ(fillProblem(surface, inside), "");
  EXPECT_NE(fillProblem(surface, regionAt(surface, labels, at(0, 0))), "") << "what lies outside of the ring";
  EXPECT_THAT(regionAt(surface, labels, -1), IsEmpty());
  EXPECT_THAT(regionAt(surface, labels, 100000), IsEmpty());
}

TEST(PatchShapes, AnUnknownPatchChangesNothing) {
  const Surface body = test::sphere(50, 3);
  const BrushSurface surface(body);
  const std::vector<int> labels = labelled(body, [](const Vector3d& p) { return p.z() > 30; });
  EXPECT_TRUE(grownPatch(surface, labels, kOther, 5).empty());
  EXPECT_TRUE(shrunkPatch(surface, labels, kOther, 5).empty());
  EXPECT_TRUE(smoothedPatch(surface, labels, kOther, 5).empty());
  EXPECT_TRUE(largestPieceOfPatch(surface, labels, kOther).empty());
  EXPECT_TRUE(filledHoles(surface, labels, kOther).empty());
}

}  // namespace
}  // namespace falciform
