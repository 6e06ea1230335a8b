#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "Logic/Acquisition/ScanScene.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/TriangleTree.h"
#include "Testing/Logic/Acquisition/SyntheticLivers.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using test::coarseLiver;

/// A square of `halfEdge` about `middle`, in the plane that a scanner at azimuth 0, elevation 0 looks at
/// square on: it stands at -y, so the square faces -y.
void addPlate(Surface& surface, const Vector3d& middle, double halfEdge) {
  const Index n = surface.size(), m = surface.triangles.rows();
  surface.points.conservativeResize(n + 4, 3);
  surface.triangles.conservativeResize(m + 2, 3);
  for (int corner = 0; corner < 4; ++corner)
    surface.points.row(n + corner) =
        (middle + halfEdge * Vector3d(corner & 1 ? 1 : -1, 0, corner & 2 ? 1 : -1)).transpose();
  const int first = static_cast<int>(n);
  surface.triangles.row(m) << first, first + 1, first + 2;
  surface.triangles.row(m + 1) << first + 2, first + 1, first + 3;
}

VirtualScannerSettings frontal(double distanceMm) {
  VirtualScannerSettings s;
  s.azimuthDeg = s.elevationDeg = 0;
  s.distanceMm = distanceMm;
  s.noiseMm = 0;
  s.windowShare = 1;
  return s;
}

Surface inPreop(const VirtualScan& scan) {
  return transformed(scan.scan, scan.scanFromPreop.inverse(), "LPS");
}

std::vector<int> pointsOf(const Surface& scan, int structure) {
  std::vector<int> ids;
  const VectorXd& of = scan.arrays.at(structure::kArray);
  for (Index i = 0; i < of.size(); ++i)
    if (of[i] == structure) ids.push_back(static_cast<int>(i));
  return ids;
}

TEST(ScanFaults, NoneChangeNothing) {
  const Surface& liver = coarseLiver().surface;
  const VirtualScan plain = scanSurface(liver, {}), none = scanSurface(liver, centroid(liver.points), {}, {});
  EXPECT_TRUE(plain.scan.points == none.scan.points);
  EXPECT_TRUE(plain.scan.colours == none.scan.colours);
  EXPECT_TRUE(none.scan.arrays.empty());
}

TEST(ScanFaults, ShadowOfAPlateHasTheWidthOfSimilarTriangles) {
  // A plate 40 mm before a wall, seen from 400 mm before the wall by a camera in its axis and a laser 100 mm
  // to one side. On the far side from the laser the wall is lost for b H / (D - H) beside the camera's own
  // shadow, on the near side nothing more is lost.
  constexpr double kDistance = 400, kHeight = 40, kBaseline = 100, kHalf = 30;
  Surface scene;
  addPlate(scene, Vector3d(0, 0, 0), 300);
  addPlate(scene, Vector3d(0, -kHeight, 0), kHalf);
  ScanFaultSettings faults;
  faults.baselineMm = kBaseline;
  const VirtualScannerSettings settings = frontal(kDistance);
  const auto gap = [&](const ScanFaultSettings& f) {  // borders of the lost strip on the wall, along x
    const Surface seen = inPreop(scanSurface(scene, Vector3d(0, 0, 0), settings, f));
    double left = -1e9, right = 1e9;
    for (Index i = 0; i < seen.size(); ++i) {
      if (std::abs(seen.points(i, 1)) > 1 || std::abs(seen.points(i, 2)) > 10) continue;  // on the wall
      (seen.points(i, 0) < 0 ? left : right) =
          seen.points(i, 0) < 0 ? std::max(left, seen.points(i, 0)) : std::min(right, seen.points(i, 0));
    }
    return std::pair(left, right);
  };
  const double cameras = kHalf * kDistance / (kDistance - kHeight),
               lasers = kBaseline * kHeight / (kDistance - kHeight);
  const double pixel = 1.2;  // mm on the wall: two samples at 35 degrees over 512
  const auto [left, right] = gap({});
  EXPECT_NEAR(left, -cameras, pixel);
  EXPECT_NEAR(right, cameras, pixel);
  const auto [withLeft, withRight] = gap(faults);
  // Which side the laser stands on is the scanner's right: one side grows by the laser's shadow.
  EXPECT_NEAR((withRight - withLeft) - (right - left), lasers, 2 * pixel);
  EXPECT_NEAR(std::min(std::abs(withLeft - left), std::abs(withRight - right)), 0, pixel);
}

TEST(ScanFaults, ConvexBodyHasNoShadowBesideWhatTheLaserSeesFlat) {
  const Surface sphere = test::sphere(60, 5);
  ScanFaultSettings faults;
  faults.baselineMm = 80;
  const VirtualScannerSettings settings = frontal(400);
  const Surface seen = inPreop(scanSurface(sphere, Vector3d(0, 0, 0), settings, faults));
  const Surface all = inPreop(scanSurface(sphere, Vector3d(0, 0, 0), settings, {}));
  ASSERT_LT(seen.size(), all.size());
  // Of the camera's points those stay that face one of the two places beside it where a laser may stand.
  Index facing[2] = {0, 0};
  for (Index i = 0; i < all.size(); ++i)
    for (int side = 0; side < 2; ++side) {
      const Vector3d p = all.points.row(i).transpose();
      facing[side] += (Vector3d(side ? 80 : -80, -400, 0) - p).dot(p) > 0;
    }
  EXPECT_NEAR(static_cast<double>(seen.size()), static_cast<double>(facing[0]),
              0.01 * static_cast<double>(all.size()));  // facets of a polyhedron at the terminator
}

TEST(ScanFaults, NoiseGrowsAsTheScannersSpecificationSays) {
  Surface wall;
  addPlate(wall, Vector3d(0, 0, 0), 80);
  for (const double distance : {300.0, 800.0}) {
    VirtualScannerSettings settings = frontal(500);
    settings.fieldOfViewDeg = 10;
    settings.noiseMm = rangeNoiseMm(500);
    ScanFaultSettings faults;
    faults.noiseGrowsWithRange = true;
    // Aimed at a place before or behind the wall: the wall stands at `distance`.
    const Surface seen = inPreop(scanSurface(wall, Vector3d(0, 500 - distance, 0), settings, faults));
    const double sd = std::sqrt(seen.points.col(1).squaredNorm() / static_cast<double>(seen.size()));
    // Rays lean by at most 7 degrees: one percent of range and of noise; plus four standard errors.
    EXPECT_NEAR(sd, rangeNoiseMm(distance),
                0.02 * sd + 4 * sd / std::sqrt(2.0 * static_cast<double>(seen.size())));
  }
}

TEST(ScanFaults, RaysAreLostMoreOftenTheFlatterTheyMeetTheSurface) {
  const Surface sphere = test::sphere(60, 6);
  VirtualScannerSettings settings = frontal(400);
  settings.stride = 1;
  ScanFaultSettings faults;
  faults.dropout = 0.8;
  const Surface all = inPreop(scanSurface(sphere, Vector3d(0, 0, 0), settings, {})),
                spoilt = inPreop(scanSurface(sphere, Vector3d(0, 0, 0), settings, faults));
  // By facing: how many there are, and how many of them should be lost.
  const double flattest = std::cos(settings.grazingDeg * M_PI / 180);
  const auto band = [&](const Surface& scan, double low) {
    std::pair<double, double> sum(0, 0);
    for (Index i = 0; i < scan.size(); ++i) {
      const Vector3d p = scan.points.row(i).transpose();
      const double facing = p.normalized().dot((Vector3d(0, -400, 0) - p).normalized());
      if (facing < low || facing >= low + 0.1) continue;
      sum.first += 1;
      sum.second += 0.8 * std::pow((1 - facing) / (1 - flattest), 2);
    }
    return sum;
  };
  for (const double low : {0.3, 0.5, 0.7, 0.9}) {
    const auto [there, lost] = band(all, low);
    // Four standard errors, and three percent: facets are not quite the sphere, and points whose neighbours
    // are all lost are left out as speckle.
    EXPECT_NEAR(band(spoilt, low).first, there - lost, 4 * std::sqrt(lost) + 0.03 * there) << low;
  }
}

TEST(ScanFaults, SmokeStandsBeforeTheOrganInTheGivenShare) {
  const Surface& liver = coarseLiver().surface;
  const Vector3d middle = centroid(liver.points);
  VirtualScannerSettings settings;
  settings.noiseMm = 0;
  ScanFaultSettings faults;
  faults.smoke = 0.05;
  const VirtualScan scan = scanSurface(liver, middle, settings, faults);
  const std::vector<int> smoke = pointsOf(scan.scan, structure::kSmoke);
  const auto n = static_cast<double>(scan.scan.size());
  EXPECT_NEAR(static_cast<double>(smoke.size()) / n, 0.05, 4 * std::sqrt(0.05 * 0.95 / n));
  const TriangleTree tree(liver);
  const Vector3d eye = middle + settings.distanceMm * towardsScanner(settings);
  const Surface back = inPreop(scan);
  for (const int i : smoke) {
    const Vector3d p = back.points.row(i).transpose();
    const auto hit = tree.cast(eye, p - eye);
    ASSERT_TRUE(hit);
    ASSERT_LE((p - eye).norm(), hit->distance + 1e-6);
    ASSERT_EQ(back.patchAt(i), patch::kNone);
  }
  EXPECT_LT(scan.coverage, scanSurface(liver, settings).coverage);
}

TEST(ScanFaults, EveryPointIsWhereItsStructureIs) {
  const Surface& liver = coarseLiver().surface;
  VirtualScannerSettings settings;
  settings.noiseMm = 0;
  ScanFaultSettings faults;
  faults.drape = true;
  faults.instruments = 3;
  const VirtualScan scan = scanSurface(liver, centroid(liver.points), settings, faults);
  const Surface back = inPreop(scan);
  const TriangleTree tree(liver);
  std::array<Index, 4> count{};
  for (Index i = 0; i < back.size(); ++i) {
    const auto which = static_cast<std::size_t>(back.arrays.at(structure::kArray)[i]);
    ++count[which];
    const double off = tree.closest(back.points.row(i).transpose()).distance;
    if (which == structure::kOrgan) {
      ASSERT_LT(off, 1e-6);  // mm
    } else {
      ASSERT_EQ(back.patchAt(i), patch::kNone);
    }
    if (which == structure::kInstrument) {
      ASSERT_GT(off, 1);
    }  // mm: the nearest rod keeps 3 mm off its footpoint
  }
  EXPECT_GT(count[structure::kOrgan], 8000);
  EXPECT_GT(count[structure::kDrape], 2000);
  EXPECT_GT(count[structure::kInstrument], 300);
  EXPECT_NO_THROW(checkSurface(scan.scan, "scan"));
}

TEST(ScanFaults, ClothAndSteelHaveOtherColoursThanTheOrgan) {
  const Surface& liver = coarseLiver().surface;
  ScanFaultSettings faults;
  faults.drape = true;
  faults.instruments = 3;
  const Surface scan = scanSurface(liver, centroid(liver.points), {}, faults).scan;
  const auto redShare = [&](int structure) {
    double sum = 0;
    const auto ids = pointsOf(scan, structure);
    for (const int i : ids)
      sum += scan.colours(i, 0) / std::max(1.0, static_cast<double>(scan.colours.row(i).cast<int>().sum()));
    return sum / static_cast<double>(ids.size());
  };
  EXPECT_GT(redShare(structure::kOrgan), 0.45);
  EXPECT_LT(redShare(structure::kDrape), 0.25);
  EXPECT_NEAR(redShare(structure::kInstrument), 1.0 / 3, 0.02);
}

TEST(ScanFaults, PhotographShowsEachPointWhereItIs) {
  // A ball painted in quarters: away from their borders the colour at a point's place in the photograph is
  // that of its quarter, however light falls on it. A place that were off by more would show another quarter.
  Surface ball = test::sphere(60, 6);
  ball.patch.resize(static_cast<std::size_t>(ball.size()));
  for (Index i = 0; i < ball.size(); ++i)
    ball.patch[static_cast<std::size_t>(i)] =
        ball.points(i, 0) * ball.points(i, 2) > 0 ? patch::kFalciform : patch::kNone;
  ScanFaultSettings faults;
  faults.photograph = true;
  VirtualScannerSettings settings = frontal(400);
  settings.fieldOfViewDeg = 20;
  settings.windowShare = 0.8;
  const Surface seen = inPreop(scanSurface(ball, Vector3d(0, 0, 0), settings, faults));
  ASSERT_TRUE(seen.texture);
  EXPECT_EQ(seen.texture->width, 1280);
  ASSERT_EQ(seen.textureAt.rows(), seen.size());
  EXPECT_GE(seen.textureAt.minCoeff(), 0);
  EXPECT_LE(seen.textureAt.maxCoeff(), 1);
  EXPECT_TRUE(seen.colours == coloursAt(*seen.texture, seen.textureAt));
  int tested = 0;
  for (Index i = 0; i < seen.size(); ++i) {
    if (std::min(std::abs(seen.points(i, 0)), std::abs(seen.points(i, 2))) < 3)
      continue;  // mm: a border's blur
    const double red = seen.colours(i, 0), green = seen.colours(i, 1);
    if (seen.points.row(i).normalized()[1] < -0.95) continue;  // the gleam
    // Parenchyma has 0.47 of green to red, the ligament 0.82.
    ASSERT_EQ(green / red > 0.65, seen.points(i, 0) * seen.points(i, 2) > 0) << seen.points.row(i);
    ++tested;
  }
  EXPECT_GT(tested, 5000);
}

TEST(ScanFaults, AreTheSameWithAnyNumberOfThreadsAndDifferBySeed) {
  const Surface& liver = coarseLiver().surface;
  ScanFaultSettings faults;
  faults.baselineMm = 60;
  faults.dropout = 0.5;
  faults.smoke = 0.02;
  faults.instruments = 2;
  faults.drape = true;
  const Vector3d middle = centroid(liver.points);
  setThreads(1);
  const VirtualScan one = scanSurface(liver, middle, {}, faults);
  setThreads(3);
  const VirtualScan three = scanSurface(liver, middle, {}, faults);
  setThreads(0);
  EXPECT_TRUE(one.scan.points == three.scan.points);
  EXPECT_TRUE(one.scan.colours == three.scan.colours);
  faults.faultSeed = 2;
  EXPECT_NE(scanSurface(liver, middle, {}, faults).scan.size(), one.scan.size());
}

}  // namespace
}  // namespace falciform
