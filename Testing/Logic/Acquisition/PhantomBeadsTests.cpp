#include "Logic/Acquisition/PhantomBeads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "Logic/Acquisition/Phantom.h"
#include "Logic/Acquisition/PhantomCt.h"
#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

LiverShape thesisLiver() { return LiverShape(thesisPhantom().liver); }

double squaredGapTo(const Landmarks& beads, const Vector3d& place) {
  double least = std::numeric_limits<double>::infinity();
  for (const Landmark& bead : beads.points) least = std::min(least, (bead.position - place).squaredNorm());
  return least;
}

/// Largest distance from a place inside to the nearest bead, over a grid of 8 mm.
double largestVoid(const LiverShape& liver, const Landmarks& beads) {
  constexpr double kStep = 8;
  const auto& box = liver.bounds();
  double worst = 0;
  for (double x = box(0, 0); x < box(1, 0); x += kStep)
    for (double y = box(0, 1); y < box(1, 1); y += kStep)
      for (double z = box(0, 2); z < box(1, 2); z += kStep) {
        const Vector3d place(x, y, z);
        if (liver.distance(place) > 0) continue;
        worst = std::max(worst, std::sqrt(squaredGapTo(beads, place)));
      }
  return worst;
}

TEST(PhantomBeads, AreAsManyAsTheThesisAndLieAtLeastSoDeep) {
  const LiverShape liver = thesisLiver();
  const Landmarks beads = placeBeads(liver);
  ASSERT_EQ(beads.points.size(), 43u);
  for (const Landmark& bead : beads.points) EXPECT_LE(liver.distance(bead.position), -5) << bead.name;
}

TEST(PhantomBeads, LeaveNoPartOfTheLiverWithoutOneAndDoNotCrowd) {
  const LiverShape liver = thesisLiver();
  const Landmarks beads = placeBeads(liver);
  // 1.5 litres over 43 beads: a cube of 33 mm each, whose corners are 28 mm from its middle. Twice that is a
  // hole that draws without regard to each other would often leave.
  EXPECT_LT(largestVoid(liver, beads), 56);
  for (std::size_t a = 0; a < beads.points.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)  // 10 mm: a third of the cube's edge
      EXPECT_GT((beads.points[a].position - beads.points[b].position).norm(), 10);
}

TEST(PhantomBeads, FollowTheSeedAndFewerAreTheFirstOfMore) {
  const LiverShape liver = thesisLiver();
  const Landmarks all = placeBeads(liver), again = placeBeads(liver), few = placeBeads(liver, {.count = 7}),
                  other = placeBeads(liver, {.seed = 2});
  for (std::size_t b = 0; b < all.points.size(); ++b) {
    EXPECT_EQ(all.points[b].position, again.points[b].position);
    EXPECT_NE(all.points[b].position, other.points[b].position);
  }
  for (std::size_t b = 0; b < few.points.size(); ++b)
    EXPECT_EQ(few.points[b].position, all.points[b].position);
}

TEST(PhantomBeads, AreFoundInTheCtWithoutClicksWithinATenthOfAMillimetre) {
  // The thesis's voxels and noise; steel is cut at what 12 bits hold, as a CT does.
  const PhantomPlan plan = thesisPhantom();
  PhantomBody body = placeSpheres(LiverShape(plan.liver), plan.phantom.sphereRadiusMm,
                                  plan.phantom.sphereGapMm, plan.scanner);
  const Landmarks truth = placeBeads(body.liver);
  for (const Landmark& bead : truth.points) body.beads.push_back(bead.position);
  const Image ct = imagePhantom(body, plan.liver.voxelMm, plan.phantom.ctNoiseHu, 1);
  EXPECT_EQ(*std::max_element(ct.voxels.begin(), ct.voxels.end()), phantom::kLargestHu);
  const Landmarks found = locateBeads(ct);
  ASSERT_EQ(found.points.size(), truth.points.size());  // none missed, no sphere or noise taken for one
  for (const Landmark& bead : truth.points)
    EXPECT_LT(std::sqrt(squaredGapTo(found, bead.position)), 0.1) << bead.name;  // mm; a voxel is 1.09 mm
}

TEST(PhantomBeads, WhatCannotBePlacedIsRefusedInWords) {
  const LiverShape liver = thesisLiver();
  EXPECT_THROW((void)placeBeads(liver, {.count = 0}), InputError);
  EXPECT_THROW((void)placeBeads(liver, {.depthMm = 200}), InputError);
}

}  // namespace
}  // namespace falciform
