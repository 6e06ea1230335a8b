#include "Logic/Acquisition/VirtualScanner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "Logic/Core/Draws.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/TriangleTree.h"
#include "Testing/Logic/Acquisition/SyntheticLivers.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using test::coarseLiver;
using test::defaultLiver;

constexpr double kDegrees = M_PI / 180;

VirtualScannerSettings withoutNoise() {
  VirtualScannerSettings settings;
  settings.noiseMm = 0;
  return settings;
}

/// The scan back in the surface's frame.
Surface inPreop(const VirtualScan& scan) {
  return transformed(scan.scan, scan.scanFromPreop.inverse(), "LPS");
}

Vector3d eyeOf(const Surface& surface, const VirtualScannerSettings& s) {
  const double az = s.azimuthDeg * kDegrees, el = s.elevationDeg * kDegrees;
  return centroid(surface.points) +
         s.distanceMm * Vector3d(-std::sin(az) * std::cos(el), -std::cos(az) * std::cos(el), std::sin(el));
}

TEST(VirtualScanner, SeesBothPatchesOfTheDefaultLiver) {
  const VirtualScan scan = scanSurface(defaultLiver().surface, {});
  EXPECT_GT(scan.coverage, 0.25);
  EXPECT_LT(scan.coverage, 0.45);
  EXPECT_GT(scan.scan.size(), 10000);
  EXPECT_LT(scan.scan.size(), 25000);
  EXPECT_GT(pointsOfPatch(scan.scan, patch::kFalciform).size(), 150u);
  EXPECT_GT(pointsOfPatch(scan.scan, patch::kInferiorRidge).size(), 400u);
  EXPECT_EQ(scan.scan.frame, "scanner");
  EXPECT_EQ(scan.scan.colours.rows(), scan.scan.size());
  EXPECT_EQ(scan.scan.normals.rows(), scan.scan.size());
  EXPECT_NO_THROW(checkSurface(scan.scan, "scan"));
}

TEST(VirtualScanner, WithoutNoiseItsPointsLieOnTheSurfaceAfterTheInverseOfTheTruth) {
  const Surface& surface = coarseLiver().surface;
  const VirtualScan scan = scanSurface(surface, withoutNoise());
  const TriangleTree tree(surface);
  const Surface back = inPreop(scan);
  double worst = 0;
  for (Index i = 0; i < back.size(); ++i)
    worst = std::max(worst, tree.closest(back.points.row(i).transpose()).distance);
  EXPECT_LT(worst, 1e-6);  // mm
}

TEST(VirtualScanner, SeesOnlyWhatIsVisibleAndNotTooFlat) {
  const Surface& surface = coarseLiver().surface;
  const VirtualScannerSettings settings = withoutNoise();
  const Surface back = inPreop(scanSurface(surface, settings));
  const TriangleTree tree(surface);
  const Vector3d eye = eyeOf(surface, settings);
  for (Index i = 0; i < back.size(); ++i) {
    const Vector3d p = back.points.row(i).transpose();
    const auto hit = tree.cast(eye, p - eye);
    ASSERT_TRUE(hit);
    ASSERT_NEAR(hit->distance, (p - eye).norm(), 1e-6);  // mm: nothing stands before it
    ASSERT_GT(tree.triangleNormal(hit->triangle).dot((eye - p).normalized()), std::cos(80 * kDegrees) - 1e-3);
    ASSERT_GT(back.normals.row(i).dot((eye - p).normalized().transpose()), 0);
  }
  for (Index t = 0; t < back.triangles.rows(); ++t) {
    const Vector3d a = back.points.row(back.triangles(t, 0)).transpose(),
                   b = back.points.row(back.triangles(t, 1)).transpose(),
                   c = back.points.row(back.triangles(t, 2)).transpose();
    ASSERT_GT((b - a).cross(c - a).dot(eye - a), 0);
  }
}

TEST(VirtualScanner, NoiseRunsAlongTheRayWithTheStatedSpread) {
  const Surface& surface = coarseLiver().surface;
  VirtualScannerSettings noisy;
  noisy.noiseMm = 1.5;
  const Surface clean = inPreop(scanSurface(surface, withoutNoise())),
                rough = inPreop(scanSurface(surface, noisy));
  ASSERT_EQ(clean.size(), rough.size());  // which rays return does not depend on the noise
  const Vector3d eye = eyeOf(surface, noisy);
  double sum = 0, squares = 0, across = 0;
  for (Index i = 0; i < clean.size(); ++i) {
    const Vector3d ray = (clean.points.row(i).transpose() - eye).normalized();
    const Vector3d error = (rough.points.row(i) - clean.points.row(i)).transpose();
    const double along = error.dot(ray);
    across = std::max(across, (error - along * ray).norm());
    sum += along;
    squares += along * along;
  }
  const auto n = static_cast<double>(clean.size());
  EXPECT_LT(across, 1e-6);                          // mm
  EXPECT_NEAR(sum / n, 0, 4 * 1.5 / std::sqrt(n));  // four standard errors
  EXPECT_NEAR(std::sqrt(squares / n), 1.5, 4 * 1.5 / std::sqrt(2 * n));
}

TEST(VirtualScanner, CoverageOfASphereIsItsVisibleCap) {
  const Surface sphere = test::sphere(60, 6);
  VirtualScannerSettings settings = withoutNoise();
  settings.grazingDeg = 90;
  settings.windowShare = 1;
  settings.distanceMm = 300;
  // From distance d a sphere of radius r shows (1 - r / d) / 2 of its area.
  EXPECT_NEAR(scanSurface(sphere, settings).coverage, (1 - 60.0 / 300) / 2, 0.01);
  settings.grazingDeg = 60;
  // A ray meets the sphere at 60 degrees to its normal where sin(angle at the eye) = r sin 60 / d; the rest
  // is plane geometry.
  const double rim = 60 * kDegrees - std::asin(60 * std::sin(60 * kDegrees) / 300);
  EXPECT_NEAR(scanSurface(sphere, settings).coverage, (1 - std::cos(rim)) / 2, 0.01);
}

TEST(VirtualScanner, CarriesPatchesOverFromTheNearestCorner) {
  const Surface& surface = coarseLiver().surface;
  const Surface back = inPreop(scanSurface(surface, withoutNoise()));
  const TriangleTree tree(surface);
  for (Index i = 0; i < back.size(); i += 7) {
    const Vector3d p = back.points.row(i).transpose();
    const ClosestPlace place = tree.closest(p);
    std::set<int> labels;  // of the nearest corners, of all that tie
    double nearest = 1e9;
    for (int k = 0; k < 3; ++k)
      nearest =
          std::min(nearest, (surface.points.row(tree.vertexOf(place.triangle, k)).transpose() - p).norm());
    for (int k = 0; k < 3; ++k) {
      const int v = tree.vertexOf(place.triangle, k);
      if ((surface.points.row(v).transpose() - p).norm() < nearest + 1e-6) labels.insert(surface.patchAt(v));
    }
    ASSERT_TRUE(labels.contains(back.patchAt(i)));
  }
}

TEST(VirtualScanner, TextureTellsTheFalciformLigamentFromTheParenchyma) {
  const Surface scan = scanSurface(coarseLiver().surface, {}).scan;
  const auto meanGreen = [&](int label) {
    const auto ids = pointsOfPatch(scan, label);
    double sum = 0;
    for (const int i : ids) sum += scan.colours(i, 1);
    return sum / static_cast<double>(ids.size());
  };
  EXPECT_GT(meanGreen(patch::kFalciform), meanGreen(patch::kNone) + 60);
  std::set<int> reds;
  for (const int i : pointsOfPatch(scan, patch::kNone)) reds.insert(scan.colours(i, 0));
  EXPECT_GT(reds.size(), 15u);  // mottled
}

TEST(VirtualScanner, RasterWindowAndStrideLimitThePoints) {
  const Surface& surface = coarseLiver().surface;
  VirtualScannerSettings settings;
  settings.fieldOfViewDeg = 10;  // the liver fills the raster
  settings.windowShare = 1;
  settings.stride = 4;
  EXPECT_LE(scanSurface(surface, settings).scan.size(), 125 * 128);
  const Index full = scanSurface(surface, {}).scan.size();
  VirtualScannerSettings half, coarse;
  half.windowShare = 0.3;
  coarse.stride = 4;
  EXPECT_LT(scanSurface(surface, half).scan.size(), 0.6 * static_cast<double>(full));
  EXPECT_LT(scanSurface(surface, half).coverage, 0.7 * scanSurface(surface, {}).coverage);
  EXPECT_NEAR(static_cast<double>(scanSurface(surface, coarse).scan.size()), 0.25 * static_cast<double>(full),
              0.05 * static_cast<double>(full));
  EXPECT_NEAR(scanSurface(surface, coarse).coverage, scanSurface(surface, {}).coverage, 0.01);
  settings.lines = 501;
  EXPECT_THROW((void)scanSurface(surface, settings), InputError);
}

TEST(VirtualScanner, LooksFromWhereItIsTold) {
  // Each view of a sphere sees the side that faces it; LPS: front -y, right -x, head +z.
  const Surface sphere = test::sphere(50, 4);
  for (const auto& [azimuth, elevation, towards] :
       {std::tuple(0.0, 0.0, Vector3d(0, -1, 0)), std::tuple(90.0, 0.0, Vector3d(-1, 0, 0)),
        std::tuple(180.0, 0.0, Vector3d(0, 1, 0)), std::tuple(0.0, 89.0, Vector3d(0, 0, 1))}) {
    VirtualScannerSettings settings = withoutNoise();
    settings.azimuthDeg = azimuth;
    settings.elevationDeg = elevation;
    const Surface back = inPreop(scanSurface(sphere, settings));
    EXPECT_GT(centroid(back.points).normalized().dot(towards), 0.99) << azimuth << ' ' << elevation;
  }
}

TEST(VirtualScanner, FramesAreProperAndDifferBySeed) {
  const Surface sphere = test::sphere(50, 3);
  VirtualScannerSettings settings;
  settings.stride = 8;
  std::vector<Isometry3d> frames;
  for (const int seed : {1, 2, 3}) {
    settings.seed = seed;
    frames.push_back(scanSurface(sphere, settings).scanFromPreop);
    EXPECT_NEAR(frames.back().linear().determinant(), 1, 1e-12);
    EXPECT_LT((frames.back().linear() * frames.back().linear().transpose() - Matrix3d::Identity()).norm(),
              1e-12);
  }
  EXPECT_GT((frames[0].linear() - frames[1].linear()).norm(), 0.1);
  EXPECT_GT((frames[1].translation() - frames[2].translation()).norm(), 1);
}

TEST(VirtualScanner, RotationsAreUniformOnSo3) {
  // Uniform on SO(3) the trace has mean 0 and variance 1, and each column is uniform on the sphere.
  constexpr int kDraws = 4000;
  double trace = 0, squares = 0;
  Vector3d column = Vector3d::Zero();
  for (int seed = 0; seed < kDraws; ++seed) {
    const Matrix3d r = Draws(static_cast<std::uint64_t>(seed), 4).rotation().toRotationMatrix();
    trace += r.trace() / kDraws;
    squares += r.trace() * r.trace() / kDraws;
    column += r.col(0) / kDraws;
  }
  EXPECT_NEAR(trace, 0, 4 / std::sqrt(kDraws));  // four standard errors
  EXPECT_NEAR(squares, 1, 0.15);
  EXPECT_LT(column.norm(), 4 / std::sqrt(kDraws));
}

TEST(VirtualScanner, IsTheSameWithAnyNumberOfThreads) {
  setThreads(1);
  const VirtualScan one = scanSurface(coarseLiver().surface, {});
  setThreads(3);
  const VirtualScan three = scanSurface(coarseLiver().surface, {});
  setThreads(0);
  EXPECT_TRUE(one.scan.points == three.scan.points);
  EXPECT_TRUE(one.scan.normals == three.scan.normals);
  EXPECT_TRUE(one.scan.triangles == three.scan.triangles);
  EXPECT_EQ(one.coverage, three.coverage);
}

TEST(VirtualScanner, SaysWhenItSeesNothing) {
  VirtualScannerSettings settings;
  settings.lines = settings.samples = 2;  // four rays, stride 2: one is left and makes no triangle
  EXPECT_THROW((void)scanSurface(coarseLiver().surface, settings), InputError);
  Surface inside = test::sphere(200, 3);  // the scanner stands inside: every hit is a back face
  EXPECT_THROW((void)scanSurface(inside, {.distanceMm = 150}), InputError);
  EXPECT_THROW((void)scanSurface(Surface{}, {}), InputError);
}

TEST(VirtualScanner, StopsOnRequest) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)scanSurface(coarseLiver().surface, {}, Progress({}, stop.get_token())), Cancelled);
}

}  // namespace
}  // namespace falciform
