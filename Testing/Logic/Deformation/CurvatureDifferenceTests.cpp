#include <gtest/gtest.h>

#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Deformation/DistanceMapping.h"
#include "Logic/Geometry/Curvature.h"
#include "Logic/Geometry/Topology.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

const Isometry3d kSamePlace = Isometry3d::Identity();

Surface asCloud(Surface surface) {
  surface.triangles.resize(0, 3);
  return surface;
}

TEST(CurvatureDifference, OfASphereGrownOrShrunkIsThatOfTheirRadii) {
  const Surface preop = test::sphere(50, 5);
  for (const double r : {47.0, 53.0}) {
    const Surface scan = test::sphere(r, 5);
    for (const Surface& side : {scan, asCloud(scan)}) {
      const DistanceMap map = mapDistances(preop, side, kSamePlace);
      const double expected = 1 / r - 1 / 50.0;  // 1/mm: a smaller sphere is more convex
      for (const Surface* surface : {&map.preop, &map.scan}) {
        const VectorXd& difference = surface->arrays.at(kCurvatureDifference);
        // 2 % of the curvature, most of which both sides share.
        EXPECT_LT((difference.array() - expected).abs().maxCoeff(), 0.02 / 50);
        EXPECT_GT(difference.maxCoeff() * expected, 0);  // and of the right sign
        EXPECT_GT(difference.minCoeff() * expected, 0);
      }
      EXPECT_NEAR(map.preopRegions.front().curvatureDifference.mean, expected, 0.004 / 50);
      EXPECT_LT((map.preop.arrays.at(kMeanCurvature).array() * 50 - 1).abs().maxCoeff(), 0.02);
    }
  }
}

TEST(CurvatureDifference, IsPositiveWhereTheScanBulgesAndNegativeWhereItIsDented) {
  const Surface preop = test::sphere(50, 5);
  Surface scan = preop;
  for (Index i = 0; i < scan.size(); ++i) {
    const Vector3d p = preop.points.row(i);
    const double up = (p - Vector3d(0, 0, 50)).squaredNorm(), down = (p + Vector3d(0, 0, 50)).squaredNorm();
    const double lift = 3 * std::exp(-up / 300) - 3 * std::exp(-down / 300);  // mm: bump above, dent below
    scan.points.row(i) *= 1 + lift / 50;
  }
  const DistanceMap map = mapDistances(preop, scan, kSamePlace);
  const VectorXd& difference = map.preop.arrays.at(kCurvatureDifference);
  for (Index i = 0; i < preop.size(); ++i) {
    // At its top the bump 3 exp(-s^2 / 300) adds the curvature 6 / 300 = 0.02 /mm; a fit over 10 mm sees
    // less.
    if (preop.points(i, 2) > 49.8) {
      EXPECT_NEAR(difference[i], 0.014, 0.006);
    }
    if (preop.points(i, 2) < -49.8) {
      EXPECT_NEAR(difference[i], -0.014, 0.006);
    }
    if (std::abs(preop.points(i, 2)) < 5) {
      EXPECT_NEAR(difference[i], 0, 1e-4);
    }
  }
}

TEST(CurvatureDifference, HasValuesWhereTheDistanceHasButNotAtTheScansBorder) {
  const Surface preop = test::lumpyBody(4), whole = test::lumpyBody(4);
  std::vector<int> upper;
  for (Index i = 0; i < whole.size(); ++i)
    if (whole.points(i, 2) > 0) upper.push_back(static_cast<int>(i));
  const Surface part = subset(whole, upper);
  for (const Surface& scan : {part, asCloud(part)}) {
    const DistanceMap map = mapDistances(preop, scan, kSamePlace);
    const VectorXd &distance = map.preop.arrays.at(kSignedDistance),
                   &difference = map.preop.arrays.at(kCurvatureDifference);
    Index covered = 0;
    for (Index i = 0; i < preop.size(); ++i) {
      if (std::isnan(distance[i])) {
        EXPECT_TRUE(std::isnan(difference[i])) << i;
      } else if (preop.points(i, 2) > 16 && scan.triangles.rows() > 0) {
        // 16 mm: the radius of a neighbourhood and a triangle off the border.
        EXPECT_NEAR(difference[i], 0, 1e-12) << i;
      } else if (preop.points(i, 2) < 1) {
        EXPECT_TRUE(std::isnan(difference[i])) << i;
      }
      covered += std::isnan(difference[i]) ? 0 : 1;
    }
    EXPECT_GT(covered, 200);
    EXPECT_EQ(map.preopRegions.front().curvatureDifference.count, covered);
    EXPECT_LT(covered, map.preopRegions.front().distance.count);
  }
}

TEST(CurvatureDifference, DoesNotChangeWhenBothMoveTogetherNorWithThreads) {
  const Surface preop = test::lumpyBody(3);
  Surface scan = preop;
  scan.points.col(2) *= 1.05;
  const Isometry3d motion = test::randomMotion(8);
  setThreads(1);
  const VectorXd still = mapDistances(preop, scan, kSamePlace).preop.arrays.at(kCurvatureDifference);
  setThreads(4);
  EXPECT_EQ(still, mapDistances(preop, scan, kSamePlace).preop.arrays.at(kCurvatureDifference));
  setThreads(0);
  const VectorXd moved =
      mapDistances(preop, transformed(scan, motion, "scanner"), motion).preop.arrays.at(kCurvatureDifference);
  EXPECT_LT((still - moved).cwiseAbs().maxCoeff(), 1e-9);  // 1/mm: rounding
}

TEST(CurvatureDifference, IsLeftOutWhereItsRadiusIsZero) {
  DistanceSettings settings;
  settings.curvatureRadiusMm = 0;
  Surface preop = test::sphere(50, 3);
  preop.arrays[kCurvatureDifference] = VectorXd::Ones(preop.size());  // of another map
  const DistanceMap map = mapDistances(preop, test::sphere(52, 3), kSamePlace, settings);
  EXPECT_EQ(map.preop.arrays.count(kCurvatureDifference), 0U);
  EXPECT_EQ(map.preopRegions.front().curvatureDifference.count, 0);
  EXPECT_TRUE(std::isnan(map.preopRegions.front().curvatureDifference.mean));
}

}  // namespace
}  // namespace falciform
