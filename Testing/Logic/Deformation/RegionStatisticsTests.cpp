#include "Logic/Deformation/RegionStatistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "Logic/Core/Errors.h"
#include "Logic/Deformation/DistanceMapping.h"
#include "Logic/Deformation/SegmentLabels.h"
#include "Logic/Geometry/Topology.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

/// A sphere of radius 50 in segments: 2 at x < 0, 7 at x > 0, none in a strip between; patch 1 at the top.
Surface segmentedSphere() {
  Surface s = test::sphere(50, 5);
  VectorXd segment(s.size());
  s.patch.assign(static_cast<std::size_t>(s.size()), 0);
  for (Index i = 0; i < s.size(); ++i) {
    const double x = s.points(i, 0);
    segment[i] = x < -5 ? 2 : x > 5 ? 7 : std::numeric_limits<double>::quiet_NaN();
    if (s.points(i, 2) > 30) s.patch[static_cast<std::size_t>(i)] = 1;
  }
  s.arrays[kCouinaudSegment] = segment;
  return s;
}

/// The part at x > 0 of a sphere of radius 52.
Surface rightHalf() {
  const Surface whole = test::sphere(52, 5);
  std::vector<int> keep;
  for (Index i = 0; i < whole.size(); ++i)
    if (whole.points(i, 0) > 0) keep.push_back(static_cast<int>(i));
  return subset(whole, keep);
}

TEST(RegionStatistics, GiveAreaCoverageAndFiguresOfAllPatchesAndSegments) {
  const DistanceMap map = mapDistances(segmentedSphere(), rightHalf(), Isometry3d::Identity());
  ASSERT_EQ(map.preopRegions.size(), 4U);
  const RegionFigures &all = map.preopRegions[0], &patch = map.preopRegions[1], &left = map.preopRegions[2],
                      &right = map.preopRegions[3];
  EXPECT_EQ(all.name, "all");
  EXPECT_EQ(patch.name, "falciform");
  EXPECT_EQ(left.name, "segment II");
  EXPECT_EQ(right.name, "segment VII");
  const double band = 2 * std::numbers::pi * 50;  // mm^2 a mm of height: the area of a spherical zone
  // 1 %: facets, and borders that run along triangles of 2 mm.
  EXPECT_NEAR(all.areaMm2 / (band * 100), 1, 0.01);
  EXPECT_NEAR(patch.areaMm2 / (band * 20), 1, 0.03);
  EXPECT_NEAR(right.areaMm2 / (band * 45), 1, 0.03);
  EXPECT_NEAR(all.coverage, 0.5, 0.01);
  EXPECT_NEAR(patch.coverage, 0.5, 0.02);
  EXPECT_NEAR(right.coverage, 1, 0.001);
  EXPECT_EQ(left.coverage, 0);
  EXPECT_NEAR(all.coveredAreaMm2(), band * 50, 0.02 * band * 50);
  // Uncovered places enter no mean.
  EXPECT_NEAR(right.distance.mean, 2, 0.01);
  EXPECT_NEAR(all.distance.mean, 2, 0.01);
  EXPECT_EQ(left.distance.count, 0);
  EXPECT_TRUE(std::isnan(left.distance.mean));
  EXPECT_TRUE(std::isnan(left.curvatureDifference.mean));
  EXPECT_NEAR(right.curvatureDifference.median, 1 / 52.0 - 1 / 50.0, 0.0002);
  EXPECT_EQ(all.distance.count, map.preopAll.count);
  EXPECT_EQ(patch.distance.count, map.preopByPatch.at(1).count);
  EXPECT_EQ(all.coverage, map.coverage);
}

TEST(RegionStatistics, OfAScanAreByTheSegmentOfTheNearestPlace) {
  Surface cloud = rightHalf();
  cloud.triangles.resize(0, 3);
  for (const Surface& scan : {rightHalf(), cloud}) {
    const DistanceMap map = mapDistances(segmentedSphere(), scan, Isometry3d::Identity());
    const VectorXd& segment = map.scan.arrays.at(kCouinaudSegment);
    for (Index i = 0; i < scan.size(); ++i) {
      const double x = scan.points(i, 0) * 50 / 52;
      if (x > 7) {  // 2 mm: a triangle beside the strip's border
        EXPECT_EQ(segment[i], 7);
      } else if (x < 3) {
        EXPECT_TRUE(std::isnan(segment[i]));
      }
    }
    ASSERT_EQ(map.scanRegions.size(), 2U);
    EXPECT_EQ(map.scanRegions[1].name, "segment VII");
    EXPECT_EQ(map.scanRegions[1].coverage, 1);
    EXPECT_EQ(std::isnan(map.scanRegions[1].areaMm2), scan.triangles.rows() == 0);
    EXPECT_NEAR(map.scanRegions[1].distance.mean, 2, 0.01);
  }
}

/// Labels 1 to 8 in octants of an oblique, anisotropic, left-handed grid; background outside a ball.
LabelMap octants() {
  LabelMap labels;
  labels.size = {24, 30, 20};
  const Matrix3d turn = Eigen::AngleAxisd(0.4, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  labels.worldFromIndex.topLeftCorner<3, 3>() = turn * Vector3d(-2, 1.5, 3).asDiagonal();
  labels.worldFromIndex.topRightCorner<3, 1>() = -turn * Vector3d(-2 * 11.5, 1.5 * 14.5, 3 * 9.5);
  for (int k = 0; k < 20; ++k)
    for (int j = 0; j < 30; ++j)
      for (int i = 0; i < 24; ++i) {
        const Vector3d p = labels.world(Vector3d(i, j, k));
        const int octant = 1 + (p.x() > 0 ? 1 : 0) + (p.y() > 0 ? 2 : 0) + (p.z() > 0 ? 4 : 0);
        labels.voxels.push_back(static_cast<std::uint16_t>(p.norm() < 15 ? octant : 0));
      }
  return labels;
}

TEST(SegmentLabels, AreThoseOfTheNearestLabelledVoxelWithinReach) {
  LabelMap labels = octants();
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-25, 25);
  Points points(500, 3);
  for (Index i = 0; i < points.rows(); ++i) points.row(i) << place(random), place(random), place(random);
  const auto check = [&](double reach) {
    const VectorXd found = labelsAtPoints(points, labels, reach);
    int none = 0;
    for (Index p = 0; p < points.rows(); ++p) {
      double best = reach;
      int expected = 0;
      for (int k = 0; k < 20; ++k)
        for (int j = 0; j < 30; ++j)
          for (int i = 0; i < 24; ++i) {
            const double d = (labels.world(Vector3d(i, j, k)) - points.row(p).transpose()).norm();
            if (labels.at(i, j, k) > 0 && d < best) best = d, expected = labels.at(i, j, k);
          }
      EXPECT_EQ(found[p], expected) << p;
      none += expected == 0;
    }
    EXPECT_GT(none, 50);
    EXPECT_LT(none, 450);
  };
  check(4);
  labels.worldFromIndex.col(0) += 0.3 * labels.worldFromIndex.col(1);  // sheared: a gantry that leaned
  check(7);
}

TEST(SegmentLabels, OfPointsFarOffTheGridAreNone) {
  Points far(3, 3);
  far << 1e9, 0, 0, -1e300, 5, 5, 0, 0, 1e5;
  EXPECT_EQ(labelsAtPoints(far, octants(), 10), VectorXd::Zero(3));
  EXPECT_THROW((void)labelsAtPoints(far, LabelMap(), 10), InputError);
}

TEST(SegmentLabels, HaveTheirCouinaudNames) {
  EXPECT_EQ(segmentName(1), "segment I");
  EXPECT_EQ(segmentName(8), "segment VIII");
  EXPECT_EQ(segmentName(9), "segment 9");
}

}  // namespace
}  // namespace falciform
