#include "Logic/Acquisition/Phantom.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "Logic/Acquisition/PhantomBody.h"
#include "Logic/Acquisition/PhantomCt.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/Geometry/TriangleTree.h"
#include "Logic/Registration/PointRegistration.h"
#include "Logic/Segmentation/SurfaceImport.h"

namespace falciform {
namespace {

/// The thesis's phantom with a quarter of the points: a second instead of ten.
PhantomPlan coarsePhantom() {
  PhantomPlan plan = thesisPhantom();
  plan.liver.edgeLengthMm = 2.5;
  plan.liver.voxelMm = 2.2;
  plan.scanner.stride = 2;
  return plan;
}

/// For claims that do not need the shape.
PhantomPlan roughPhantom() {
  PhantomPlan plan = coarsePhantom();
  plan.liver.edgeLengthMm = 6;
  plan.liver.voxelMm = 4;
  return plan;
}

double largestDistance(const Landmarks& a, const Landmarks& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    largest = std::max(largest, (a.points[i].position - b.points[i].position).norm());
  return largest;
}

PhantomBody bodyOf(const PhantomPlan& plan) {
  return placeSpheres(LiverShape(plan.liver), plan.phantom.sphereRadiusMm, plan.phantom.sphereGapMm,
                      plan.scanner);
}

TEST(PhantomBody, NoSphereTouchesOrHidesAnything) {
  for (const int seed : {1, 2, 3}) {
    PhantomPlan plan = coarsePhantom();
    plan.liver.seed = seed;
    plan.liver.variation = seed == 1 ? 0 : 0.2;
    const PhantomBody body = bodyOf(plan);
    const Vector3d eye = middleOf(body.liver) + plan.scanner.distanceMm * towardsScanner(plan.scanner);
    ASSERT_EQ(body.spheres.size(), 7u);
    for (const Vector3d& centre : body.spheres) {
      EXPECT_GT(body.liver.distance(centre), body.sphereRadiusMm + 5);  // mm of air
      for (const Vector3d& other : body.spheres) {
        if (&other == &centre) continue;
        const double angle = std::acos((centre - eye).normalized().dot((other - eye).normalized()));
        const auto outline = [&](const Vector3d& c) {
          return std::asin(body.sphereRadiusMm / (c - eye).norm());
        };
        EXPECT_GT(angle, outline(centre) + outline(other));
      }
      // Sight lines to the sphere's outline, carried on behind it, miss the liver.
      const Vector3d sight = (centre - eye).normalized(), side = sight.unitOrthogonal(),
                     up = sight.cross(side);
      for (int n = 0; n < 12; ++n) {
        const double turn = n * M_PI / 6;
        const Vector3d rim = centre + body.sphereRadiusMm * (std::cos(turn) * side + std::sin(turn) * up);
        for (double t = 0.5; t < 1.6; t += 0.01) EXPECT_GT(body.liver.distance(eye + t * (rim - eye)), 0);
      }
    }
  }
}

TEST(PhantomBody, SpheresFitInOneOrderOnly) {
  const PhantomBody body = bodyOf(coarsePhantom());
  Points places(7, 3);
  for (Index i = 0; i < 7; ++i) places.row(i) = body.spheres[static_cast<std::size_t>(i)].transpose();
  std::vector<int> order(7);
  std::iota(order.begin(), order.end(), 0);
  double second = 1e9;
  while (std::next_permutation(order.begin(), order.end())) {
    Points swapped(7, 3);
    for (Index i = 0; i < 7; ++i) swapped.row(i) = places.row(order[static_cast<std::size_t>(i)]);
    const VectorXd errors = targetErrors(places, swapped, fitRigid(places, swapped));
    second = std::min(second, std::sqrt(errors.squaredNorm() / 7));
  }
  EXPECT_GT(second, 10);  // mm of FRE, against hundredths in the right order
}

TEST(PhantomCt, MaterialsNoiseAndSurfacesAreWhereTheyShouldBe) {
  const PhantomBody body = bodyOf(coarsePhantom());
  const Image clean = imagePhantom(body, 2.2, 0, 1), noisy = imagePhantom(body, 2.2, 15, 1);
  double squares = 0;
  Index deep = 0;
  for (int k = 0; k < clean.size.z(); ++k)
    for (int j = 0; j < clean.size.y(); ++j)
      for (int i = 0; i < clean.size.x(); ++i) {
        const Vector3d p = clean.world(Vector3d(i, j, k));
        double toSphere = 1e9;
        for (const Vector3d& centre : body.spheres)
          toSphere = std::min(toSphere, (p - centre).norm() - body.sphereRadiusMm);
        const double toLiver = body.liver.distance(p);
        if (std::min(std::abs(toLiver), std::abs(toSphere)) < 8) continue;  // partial volume
        const double hu = toLiver < 0    ? phantom::kSiliconeHu
                          : toSphere < 0 ? phantom::kTeflonHu
                                         : phantom::kAirHu;
        ASSERT_EQ(clean.at(i, j, k), hu);
        squares += std::pow(noisy.at(i, j, k) - hu, 2);
        ++deep;
      }
  ASSERT_GT(deep, 100000);
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(deep)), 15, 0.15);  // HU: four standard errors

  const Surface surface = siliconeSurface(noisy);
  EXPECT_TRUE(inspectTopology(surface).closedManifold()) << describeTopology(inspectTopology(surface));
  double sum = 0, worst = 0;
  for (Index i = 0; i < surface.size(); ++i) {
    const double off = body.liver.distance(surface.points.row(i).transpose());
    sum += off * off / static_cast<double>(surface.size());
    worst = std::max(worst, std::abs(off));
  }
  EXPECT_LT(std::sqrt(sum), 0.1);  // mm: a twentieth of a voxel
  EXPECT_LT(worst, 0.7);           // mm: the sharpest bend of the margin, 3 mm, against voxels of 2.2 mm
}

TEST(Phantom, ScanLiesOnTheLiverByTheTruth) {
  const PhantomPlan plan = coarsePhantom();
  const PhantomCase made = makePhantomCase(plan);
  const LiverShape liver(plan.liver);
  const Points back = transformed(made.scan.points, made.scanFromPreop.inverse());
  double sum = 0;
  for (Index i = 0; i < back.rows(); ++i) sum += std::pow(liver.distance(back.row(i).transpose()), 2);
  const double rms = std::sqrt(sum / static_cast<double>(back.rows()));
  EXPECT_LT(rms, plan.scanner.noiseMm);  // the noise runs along the ray, so less of it stands off the surface
  EXPECT_GT(rms, 0.5 * plan.scanner.noiseMm);
  EXPECT_EQ(made.scan.frame, "scanner");
  EXPECT_EQ(made.spheresScan.frame, "scanner");
  for (std::size_t i = 0; i < made.targets.points.size(); ++i)
    EXPECT_LT(
        (made.scanFromPreop * made.targets.points[i].position - made.trueTargets.points[i].position).norm(),
        1e-9);  // mm
  EXPECT_THAT(patchLabels(made.scan), testing::ElementsAre(patch::kFalciform, patch::kInferiorRidge));
  EXPECT_THAT(patchLabels(made.subRegion), testing::ElementsAre(patch::kFalciform, patch::kInferiorRidge));
  EXPECT_EQ(patchLabels(made.wholeView).size(), 7u);
  EXPECT_LT(made.subRegion.size(), made.scan.size() / 2);
}

TEST(Phantom, SpheresAreLocatedInCtAndScan) {
  for (const int seed : {1, 2}) {
    PhantomPlan plan = coarsePhantom();
    plan.phantom.seed = plan.scanner.seed = seed;
    const PhantomCase made = makePhantomCase(plan);
    EXPECT_LT(largestDistance(made.spheresCt, made.trueSpheresCt), 0.02);  // mm; a voxel is 2.2 mm
    // About 180 points a sphere, noise 0.51 mm: 2 x 0.51 / sqrt(180) = 0.08 mm RMS; largest of seven, twice
    // that.
    EXPECT_LT(largestDistance(made.spheresScan, made.trueSpheresScan), 0.2);
  }
}

TEST(Phantom, CoarseVoxelsKeepTheLiverOutOfTheSpheres) {
  const PhantomCase made = makePhantomCase(roughPhantom());
  // A sphere of 134 voxels: its centre is good to some hundredths of a voxel of 4 mm.
  EXPECT_LT(largestDistance(made.spheresCt, made.trueSpheresCt), 0.1);
}

TEST(Phantom, LabelMapGivesTheSameLiverByTheImportPath) {
  const PhantomCase made = makePhantomCase(coarsePhantom());
  SurfaceImportSettings settings;
  settings.labels = {phantom::kSiliconeLabel};
  const SurfaceImportResult imported = importSurface(made.labels, settings);
  EXPECT_NEAR(static_cast<double>(imported.surface.size()), static_cast<double>(made.ctSurface.size()),
              0.1 * static_cast<double>(made.ctSurface.size()));
  const TriangleTree tree(imported.surface);
  double sum = 0;
  for (Index i = 0; i < made.ctSurface.size(); ++i)
    sum += std::pow(tree.closest(made.ctSurface.points.row(i).transpose()).distance, 2);
  EXPECT_LT(std::sqrt(sum / static_cast<double>(made.ctSurface.size())), 0.5);  // mm: a quarter of a voxel
}

TEST(Phantom, NoiseFollowsTheScannersSpecification) {
  EXPECT_NEAR(rangeNoiseMm(300), 0.3, 1e-12);  // mm
  EXPECT_NEAR(rangeNoiseMm(800), 1.0, 1e-12);
  EXPECT_NEAR(thesisPhantom().scanner.noiseMm, 0.51, 1e-12);  // at 450 mm
}

TEST(Phantom, IsTheSameWithAnyNumberOfThreadsAndDiffersBySeed) {
  PhantomPlan plan = roughPhantom();
  setThreads(1);
  const PhantomCase one = makePhantomCase(plan);
  setThreads(3);
  const PhantomCase three = makePhantomCase(plan);
  setThreads(0);
  EXPECT_TRUE(one.ct.voxels == three.ct.voxels);
  EXPECT_TRUE(one.ctSurface.points == three.ctSurface.points);
  EXPECT_TRUE(one.scan.points == three.scan.points);
  EXPECT_TRUE(one.scan.patch == three.scan.patch);
  EXPECT_EQ(largestDistance(one.spheresScan, three.spheresScan), 0);
  EXPECT_EQ(largestDistance(one.spheresCt, three.spheresCt), 0);
  plan.phantom.seed = plan.scanner.seed = 2;
  EXPECT_GT(largestDistance(makePhantomCase(plan).spheresScan, one.spheresScan), 1);  // mm: another frame
}

TEST(Phantom, SaysWhichSphereIsNotInView) {
  PhantomPlan plan = roughPhantom();
  plan.scanner.windowShare = 0.4;
  try {
    (void)makePhantomCase(plan);
    ADD_FAILURE() << "a scan without spheres has no gold standard";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("sphere"));
  }
  EXPECT_THROW((void)locateSphere(Points::Zero(100, 3), Vector3d(0, 0, 0), 12.7), InputError);  // one place
  EXPECT_THROW((void)locateSphere(Points::Random(100, 3), Vector3d(90, 0, 0), 12.7), InputError);
}

}  // namespace
}  // namespace falciform
