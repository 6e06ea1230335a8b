#include "Logic/Deformation/DistanceMapping.h"

#include <gtest/gtest.h>

#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

const Isometry3d kSamePlace = Isometry3d::Identity();

const VectorXd& distances(const Surface& surface) { return surface.arrays.at(kSignedDistance); }

Surface asCloud(Surface surface) {
  surface.triangles.resize(0, 3);
  return surface;
}

/// The part of a surface above `height`.
Surface above(const Surface& surface, double height) {
  std::vector<int> keep;
  for (Index i = 0; i < surface.size(); ++i)
    if (surface.points(i, 2) > height) keep.push_back(static_cast<int>(i));
  return subset(surface, keep);
}

TEST(DistanceMapping, OfASphereGrownOrShrunkBy3MmIsPlusOrMinus3MmEverywhere) {
  const Surface preop = test::sphere(50, 4);
  for (const double grown : {3.0, -3.0}) {
    const Surface scan = test::sphere(50 + grown, 4);
    for (const Surface& side : {scan, asCloud(scan)}) {
      const DistanceMap map = mapDistances(preop, side, kSamePlace);
      // 0.01 mm: a facet of 3 mm edges is nearer than the corner above by up to 1 - cos(2 deg) of 3 mm.
      EXPECT_LT((distances(map.preop).array() - grown).abs().maxCoeff(), 0.01);
      EXPECT_LT((distances(map.scan).array() - grown).abs().maxCoeff(), 0.01);
      EXPECT_NEAR(map.preopAll.mean, grown, 0.01);
      EXPECT_NEAR(map.scanAll.mean, grown, 0.01);
      EXPECT_DOUBLE_EQ(map.coverage, 1);
      EXPECT_EQ(map.scanAll.count, side.size());
    }
  }
}

TEST(DistanceMapping, OfAPartialScanHasNoValueBeyondItsBorder) {
  const Surface preop = test::sphere(50, 5);
  const Surface part = above(test::sphere(53, 5), 10);
  for (const Surface& scan : {part, asCloud(part)}) {
    const DistanceMap map = mapDistances(preop, scan, kSamePlace);
    for (Index i = 0; i < preop.size(); ++i) {
      const double z = preop.points(i, 2) * 53 / 50, d = distances(map.preop)[i];
      // 3.5 mm: two edges of the sphere, as the border runs along whole triangles, and a cloud has none
      // drawn.
      if (z > 13.5) {
        EXPECT_NEAR(d, 3, 0.01) << "z = " << z;
      }
      if (z < 6.5) {
        EXPECT_TRUE(std::isnan(d)) << "z = " << z << ", d = " << d;
      }
      if (!std::isnan(d)) {
        // mm: at the border 15 deg aside (3.5 %); of a cloud, whose border is not drawn, one spacing of 2 mm
        // aside.
        EXPECT_NEAR(d, 3, scan.triangles.rows() > 0 ? 0.12 : std::hypot(3, 2.2) - 3);
      }
    }
    // A cap of height h on a sphere of radius r has the share h / 2r of its area; the border is uncertain by
    // 2 mm of height.
    EXPECT_NEAR(map.coverage, (53 - 10) / (2 * 53.0), 2 / (2 * 53.0));
    EXPECT_LT((distances(map.scan).array() - 3).abs().maxCoeff(), 0.01);
  }
}

TEST(DistanceMapping, OfAScanInContactEndsAtItsBorderToo) {
  // No distance, no offset to judge: the border is all that limits it.
  const Surface preop = test::sphere(50, 5);
  const Surface part = above(preop, 10);
  for (const Surface& scan : {part, asCloud(part)}) {
    const DistanceMap map = mapDistances(preop, scan, kSamePlace);
    for (Index i = 0; i < preop.size(); ++i)
      if (preop.points(i, 2) > 10) {
        EXPECT_NEAR(distances(map.preop)[i], 0, 1e-9);
      } else if (preop.points(i, 2) < 6.5) {
        EXPECT_TRUE(std::isnan(distances(map.preop)[i])) << preop.points(i, 2);
      }
  }
}

TEST(DistanceMapping, IsPositiveWhereTheScanLiesOutside) {
  // A ball in the middle of the scan, moved by 4 mm along x: the scan lies outside at +x, inside at -x.
  const Surface preop = test::sphere(50, 4);
  Surface scan = test::sphere(50, 5);
  scan.points.col(0).array() += 4;
  for (const Surface& side : {scan, asCloud(scan)}) {
    const DistanceMap map = mapDistances(preop, side, kSamePlace);
    for (Index i = 0; i < preop.size(); ++i) {
      const double expected = 50 - (Vector3d(preop.points.row(i)) - Vector3d(4, 0, 0)).norm();
      // mm: facets lie up to 0.06 under the sphere; points 2 mm apart are 1.2 aside at most, which adds 1.2^2
      // / 2d at d = 2.
      if (std::abs(expected) > 2) {
        EXPECT_NEAR(distances(map.preop)[i], expected, side.triangles.rows() > 0 ? 0.06 : 0.4);
      }
    }
    for (Index i = 0; i < side.size(); ++i) {
      const Vector3d p = side.points.row(i);
      EXPECT_NEAR(distances(map.scan)[i], p.norm() - 50,
                  0.06);  // mm: facets of 4 mm edges lie 2.3^2 / 2r under the sphere
    }
  }
}

TEST(DistanceMapping, HasNoValueBeyondReach) {
  const Surface preop = test::sphere(50, 3);
  DistanceSettings settings;
  settings.reachMm = 5;
  const DistanceMap map = mapDistances(preop, test::sphere(55.2, 3), kSamePlace, settings);
  EXPECT_TRUE(distances(map.preop).array().isNaN().all());
  EXPECT_TRUE(distances(map.scan).array().isNaN().all());
  EXPECT_EQ(map.coverage, 0);
  EXPECT_EQ(map.preopAll.count, 0);
  EXPECT_TRUE(std::isnan(map.preopAll.mean));
}

TEST(DistanceMapping, DoesNotCoverTheFarSideOfAThinLobe) {
  // A slab 4 mm thick; the scan lies 1 mm above its top: the underside is within reach, but faces away.
  Surface preop = test::sphere(1, 5);
  for (Index i = 0; i < preop.size(); ++i) {  // a superellipsoid: flat top and bottom, round rim
    const Vector3d p = preop.points.row(i);
    const double norm = std::pow(std::pow(p.x(), 4) + std::pow(p.y(), 4) + std::pow(p.z(), 4), 0.25);
    preop.points.row(i) = p.cwiseProduct(Vector3d(40, 40, 2)) / norm;
  }
  Surface top = test::grid(50, 50);
  top.points.rowwise() -= Eigen::RowVector3d(25, 25, -3);
  Surface withNormals = asCloud(top);
  withNormals.normals = Points::Zero(top.size(), 3);
  withNormals.normals.col(2).setOnes();
  for (const Surface& scan : {top, withNormals, asCloud(top)}) {
    const DistanceMap map = mapDistances(preop, scan, kSamePlace);
    int covered = 0;
    for (Index i = 0; i < preop.size(); ++i) {
      const double d = distances(map.preop)[i];
      if (preop.points(i, 2) < -1) {
        EXPECT_TRUE(std::isnan(d));
      } else if (!std::isnan(d)) {
        EXPECT_GT(d, 0);
        ++covered;
      }
    }
    EXPECT_GT(covered, 500);
  }
}

TEST(DistanceMapping, OfScanPointsBeyondTheBorderOfAnOpenPreopSurfaceHasNoValue) {
  Surface scan = test::grid(40, 40);
  scan.points.rowwise() += Eigen::RowVector3d(-10, -10, 2);
  const DistanceMap map = mapDistances(test::grid(20, 20), scan, kSamePlace);
  for (Index i = 0; i < scan.size(); ++i) {
    const Vector3d p = scan.points.row(i);
    const bool over = p.x() >= 0 && p.x() <= 20 && p.y() >= 0 && p.y() <= 20;
    EXPECT_EQ(!std::isnan(distances(map.scan)[i]), over) << p.transpose();
    if (over) {
      EXPECT_NEAR(distances(map.scan)[i], 2, 1e-12);
    }
  }
}

TEST(DistanceMapping, DoesNotChangeWhenBothMoveTogether) {
  const Surface preop = test::lumpyBody(3);
  Surface scan = above(preop, centroid(preop.points).z());
  scan.points *= 1.02;
  const Isometry3d motion = test::randomMotion(8);
  for (const Surface& side : {scan, asCloud(scan)}) {
    const DistanceMap still = mapDistances(preop, side, kSamePlace);
    const DistanceMap moved = mapDistances(preop, transformed(side, motion, "scanner"), motion);
    EXPECT_EQ(moved.preop.frame, "scanner");
    EXPECT_GT(still.preopAll.count, 100);
    for (const auto& [a, b] : {std::pair(&still.preop, &moved.preop), std::pair(&still.scan, &moved.scan)})
      for (Index i = 0; i < a->size(); ++i) {
        ASSERT_EQ(std::isnan(distances(*a)[i]), std::isnan(distances(*b)[i])) << i;
        if (!std::isnan(distances(*a)[i])) {
          ASSERT_NEAR(distances(*a)[i], distances(*b)[i], 1e-9);
        }
      }
    EXPECT_NEAR(still.coverage, moved.coverage, 1e-12);
  }
}

TEST(DistanceMapping, IsTheSameOnAnyNumberOfThreads) {
  const Surface preop = test::lumpyBody(4);
  const Surface scan = asCloud(above(test::lumpyBody(4), 0));
  setThreads(1);
  const DistanceMap one = mapDistances(preop, scan, kSamePlace);
  setThreads(4);
  const DistanceMap four = mapDistances(preop, scan, kSamePlace);
  setThreads(0);
  for (Index i = 0; i < preop.size(); ++i) {
    const double a = distances(one.preop)[i], b = distances(four.preop)[i];
    ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b)));
  }
  EXPECT_EQ(one.scanAll.rms, four.scanAll.rms);
  EXPECT_EQ(one.coverage, four.coverage);
}

TEST(DistanceMapping, GivesFiguresPerPatchOfTheCoveredPointsAlone) {
  Surface preop = test::sphere(50, 4);
  preop.patch.assign(static_cast<std::size_t>(preop.size()), 0);
  for (Index i = 0; i < preop.size(); ++i) {
    if (preop.points(i, 2) > 40) preop.patch[static_cast<std::size_t>(i)] = 1;            // all covered
    if (std::abs(preop.points(i, 0)) > 45) preop.patch[static_cast<std::size_t>(i)] = 2;  // half of it
    if (preop.points(i, 2) < -40) preop.patch[static_cast<std::size_t>(i)] = 5;           // none
  }
  const DistanceMap map = mapDistances(preop, above(test::sphere(52, 4), 0), kSamePlace);
  ASSERT_EQ(map.preopByPatch.size(), 3U);
  EXPECT_TRUE(map.scanByPatch.empty());
  EXPECT_EQ(map.preopByPatch.at(1).count, static_cast<Index>(pointsOfPatch(preop, 1).size()));
  EXPECT_NEAR(map.preopByPatch.at(1).mean, 2, 0.01);  // mm: facets, as above
  EXPECT_GT(map.preopByPatch.at(2).count, 0);
  EXPECT_LT(map.preopByPatch.at(2).count, static_cast<Index>(pointsOfPatch(preop, 2).size()));
  EXPECT_NEAR(map.preopByPatch.at(2).mean, 2, 0.08);  // mm: 3.5 % at the border
  EXPECT_EQ(map.preopByPatch.at(5).count, 0);
  EXPECT_TRUE(std::isnan(map.preopByPatch.at(5).mean));
  const DistanceStatistics naive = distanceStatistics(distances(map.preop));
  EXPECT_EQ(naive.count, map.preopAll.count);
  EXPECT_EQ(naive.mean, map.preopAll.mean);
}

TEST(DistanceMapping, KeepsWhatTheSurfacesCarried) {
  Surface preop = test::sphere(50, 2), scan = test::sphere(51, 2);
  preop.arrays["thickness_mm"] = VectorXd::Ones(preop.size());
  scan.colours = Colours::Constant(scan.size(), 3, 7);
  const DistanceMap map = mapDistances(preop, scan, kSamePlace);
  EXPECT_EQ(map.preop.arrays.count("thickness_mm"), 1U);
  EXPECT_EQ(map.scan.colours, scan.colours);
  EXPECT_EQ(map.scan.points, scan.points);
}

TEST(DistanceMapping, RefusesWhatCannotBeMeasured) {
  const Surface body = test::sphere(50, 2);
  EXPECT_THROW((void)mapDistances(asCloud(body), body, kSamePlace), InputError);
  EXPECT_THROW((void)mapDistances(body, Surface(), kSamePlace), InputError);
  DistanceSettings settings;
  settings.reachMm = -1;
  EXPECT_THROW((void)mapDistances(body, body, kSamePlace, settings), InputError);
  Isometry3d broken = Isometry3d::Identity();
  broken.translation().x() = NAN;
  EXPECT_THROW((void)mapDistances(body, body, broken), InputError);
}

TEST(DistanceMapping, TakesACloudOfOnePoint) {
  Surface scan;
  scan.points = Points::Zero(1, 3);
  scan.points(0, 2) = 51;
  const DistanceMap map = mapDistances(test::sphere(50, 3), scan, kSamePlace);
  EXPECT_EQ(map.scanAll.count, 1);
  EXPECT_NEAR(map.scanAll.mean, 1, 0.3);  // mm: sagitta of 6 mm facets
}

TEST(DistanceMapping, StopsWhenAskedTo) {
  std::stop_source stop;
  const Progress progress(
      [&](double fraction, std::string_view) {
        if (fraction > 0.3) stop.request_stop();
      },
      stop.get_token());
  EXPECT_THROW((void)mapDistances(test::sphere(50, 5), test::sphere(50, 5), kSamePlace, {}, progress),
               Cancelled);
}

}  // namespace
}  // namespace falciform
