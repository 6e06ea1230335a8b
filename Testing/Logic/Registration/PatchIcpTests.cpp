#include "Logic/Registration/PatchIcp.h"

#include <gtest/gtest.h>

#include "Logic/Geometry/Measures.h"
#include "Testing/Logic/Registration/PartialScan.h"

namespace falciform {
namespace {

using test::lumpyBody;
using test::partialScan;
using test::placedApart;
using test::randomMotion;

const Vector3d kView(0.1, -0.6, 0.8);

LabelledSource sourceOf(const Surface& scan) { return {scan.points, scan.patch}; }

TEST(PatchWeight, FallsFromLargestToBase) {
  RegistrationSettings s = registrationPreset("thesis-phantom");
  EXPECT_DOUBLE_EQ(patchWeight(s, 1), 1000);  // the erratum of Eq. (III.3): w(1) = w_max
  EXPECT_NEAR(patchWeight(s, 101), 1000 * std::exp(-1.0) + 25 * (1 - std::exp(-1.0)), 1e-9);
  EXPECT_NEAR(patchWeight(s, 5000), 25, 1e-9);
  s.method = RegistrationMethod::Wgf;
  EXPECT_DOUBLE_EQ(patchWeight(s, 700), 1000);
  s.method = RegistrationMethod::Icp;
  EXPECT_DOUBLE_EQ(patchWeight(s, 1), 1);
}

TEST(RegistrationPresets, HoldTheThesissValues) {
  const RegistrationSettings clinical = registrationPreset("thesis-clinical");
  EXPECT_EQ(clinical.weightMax, 3000);
  EXPECT_EQ(clinical.weightBase, 25);
  EXPECT_EQ(clinical.relaxation, 0.005);
  EXPECT_EQ(clinical.correspondenceWeight, 1e-4);
  EXPECT_EQ(clinical.maxIterations, 1000);
  EXPECT_EQ(clinical.rmsToleranceMm, 1e-4);
  EXPECT_EQ(clinical.stop, StopRule::Rms);
  EXPECT_EQ(clinical.robustScaleMm, 0);
  EXPECT_EQ(clinical.start, RegistrationStart::Given);
  EXPECT_THROW((void)registrationPreset("thesis"), InputError);
}

TEST(PatchIcp, RecoversANearbyPoseAsWellAsVerticesAllow) {
  const Surface body = lumpyBody(5);
  const Isometry3d truth = randomMotion(3);
  const Surface scan = partialScan(body, kView, 70, 3, truth);
  const LabelledTarget target(body, {1, 2});
  const Isometry3d start = truth.inverse() * Eigen::AngleAxisd(0.3, Vector3d(1, 2, 3).normalized()) *
                           Eigen::Translation3d(15, -10, 8);
  const PatchIcpResult run = runPatchIcp(target, sourceOf(scan), {}, start);
  EXPECT_TRUE(run.converged) << run.stopReason;
  // Closest *vertices* lock the scan within about an edge (3 mm here) of the truth; twice that is the wrong
  // place.
  EXPECT_LT(placedApart(scan.points, run.preopFromScan, truth.inverse()), 2 * meanEdgeLength(body));
  EXPECT_GT(placedApart(scan.points, start, truth.inverse()), 30);  // mm: it had a way to go
}

TEST(PatchIcp, StaysAtTheTruth) {
  const Surface body = lumpyBody(5);
  const Isometry3d truth = randomMotion(3);
  const Surface scan = partialScan(body, kView, 70, 3, truth);
  const PatchIcpResult run = runPatchIcp(LabelledTarget(body, {1, 2}), sourceOf(scan), {}, truth.inverse());
  EXPECT_LT(placedApart(scan.points, run.preopFromScan, truth.inverse()),
            1e-9);  // mm: every pair is a point with itself
}

TEST(PatchIcp, ResidualNeverRisesAtConstantWeightWithoutRobustness) {
  // Besl and McKay's theorem: closest points, then least squares; neither step can raise the energy.
  const Surface body = lumpyBody(4);
  const Surface scan = partialScan(body, kView, 80, 1, randomMotion(4), 1.0);
  RegistrationSettings settings;
  settings.method = RegistrationMethod::Icp;
  settings.robustScaleMm = 0;
  const PatchIcpResult run =
      runPatchIcp(LabelledTarget(body, {}), sourceOf(scan), settings, Isometry3d::Identity());
  for (std::size_t i = 1; i < run.history.size(); ++i)
    ASSERT_LE(run.history[i].rmsMm, run.history[i - 1].rmsMm + 1e-12) << "iteration " << i;
}

TEST(PatchIcp, StopsOnMotionOnlyWhenTheWeightHasRelaxed) {
  const Surface body = lumpyBody(4);
  const Surface scan = partialScan(body, kView, 80, 1, Isometry3d::Identity());
  RegistrationSettings settings;  // started at the answer: nothing moves from the first step on
  const PatchIcpResult run =
      runPatchIcp(LabelledTarget(body, {1, 2}), sourceOf(scan), settings, Isometry3d::Identity());
  EXPECT_TRUE(run.converged);
  EXPECT_LE(run.history.back().patchWeight, 1.01 * settings.weightBase);
  EXPECT_GT(run.history.size(), 100u);
}

TEST(PatchIcp, TheThesissRuleStopsWhileTheWeightStillFalls) {
  const Surface body = lumpyBody(4);
  const Surface scan = partialScan(body, kView, 80, 1, Isometry3d::Identity());
  const PatchIcpResult run = runPatchIcp(LabelledTarget(body, {1, 2}), sourceOf(scan),
                                         registrationPreset("thesis-phantom"), Isometry3d::Identity());
  EXPECT_TRUE(run.converged);
  EXPECT_GT(run.history.back().patchWeight, 900);
}

TEST(PatchIcp, IgnoresOutliersWithRobustWeights) {
  const Surface body = lumpyBody(5);
  const Isometry3d truth = randomMotion(6);
  Surface scan = partialScan(body, kView, 70, 3, truth);
  const Vector3d away = truth.linear() * kView.normalized();
  for (Index i = 0; i < scan.size(); i += 12)
    scan.points.row(i) += 60 * away.transpose();  // 8 %: smoke above the surface
  const LabelledTarget target(body, {1, 2});
  const Isometry3d start = truth.inverse();
  RegistrationSettings plain;
  plain.robustScaleMm = 0;
  RegistrationSettings robust;
  robust.robustScaleMm = 5;
  const double plainError = placedApart(
      scan.points, runPatchIcp(target, sourceOf(scan), plain, start).preopFromScan, truth.inverse());
  const double robustError = placedApart(
      scan.points, runPatchIcp(target, sourceOf(scan), robust, start).preopFromScan, truth.inverse());
  EXPECT_LT(robustError, 0.01);  // mm: a Welsch weight at 60 mm and scale 5 mm is exp(-72)
  EXPECT_GT(plainError, 1);      // mm: the same without, so the test can tell
}

TEST(PatchIcp, CancelStopsIt) {
  const Surface body = lumpyBody(4);
  std::stop_source stop;
  const Progress progress([&](double, std::string_view) { stop.request_stop(); }, stop.get_token());
  EXPECT_THROW((void)runPatchIcp(LabelledTarget(body, {}), sourceOf(body), {}, randomMotion(1), 1, progress),
               Cancelled);
}

}  // namespace
}  // namespace falciform
