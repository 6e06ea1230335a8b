#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Sampling.h"
#include "Logic/Registration/ClosestPointLoop.h"
#include "Logic/Registration/ClosestPointTransform.h"
#include "Logic/Registration/ColourIcp.h"
#include "Logic/Registration/Dirr.h"
#include "Testing/Logic/Registration/PartialScan.h"

namespace falciform {
namespace {

using test::lumpyBody;
using test::partialScan;
using test::placedApart;
using test::randomMotion;

const Vector3d kView(0.1, -0.6, 0.8);

/// 10 deg about an axis through the scan's own place and 9 mm off.
Isometry3d startNear(const Surface& scan, const Isometry3d& preopFromScan, double deg = 10) {
  const Vector3d middle = preopFromScan * scan.points.colwise().mean().transpose();
  return Eigen::Translation3d(middle + Vector3d(6, -5, 4)) *
         Eigen::AngleAxisd(deg * EIGEN_PI / 180, Vector3d(1, 2, -1).normalized()) *
         Eigen::Translation3d(-middle) * preopFromScan;
}

/// Smoothly varying tints, no two sides alike.
void paintTexture(Surface& surface) {
  surface.colours.resize(surface.size(), 3);
  for (Index i = 0; i < surface.size(); ++i) {
    const Vector3d d = surface.points.row(i).normalized();
    const Vector3d tint(std::sin(4 * d.x() + d.y()), std::sin(5 * d.y() - d.z()),
                        std::cos(4 * d.z() + 2 * d.x()));
    surface.colours.row(i) = (tint * 100 + Vector3d::Constant(128)).cast<std::uint8_t>().transpose();
  }
}

TEST(Dirr, RecoversANearbyPose) {
  const Surface body = lumpyBody(4);
  const Isometry3d truth = randomMotion(3);
  const Surface scan = partialScan(body, kView, 70, 1, truth);
  const Isometry3d start = startNear(scan, truth.inverse());
  const PatchIcpResult run = registerDirr(PreparedPreop(body), scan, {}, start);
  EXPECT_TRUE(run.converged) << run.stopReason;
  // The truth puts every point on the surface: a misfit of 0, which a smooth objective pins to its tolerance.
  EXPECT_LT(placedApart(scan.points, run.preopFromScan, truth.inverse()), 0.1);  // mm
  EXPECT_GT(placedApart(scan.points, start, truth.inverse()), 15);
}

TEST(Dirr, LetsADisplacedThirdGoWhereIcpSharesTheErrorOut) {
  const Surface body = lumpyBody(4);
  const Isometry3d truth = randomMotion(7);
  Surface scan = partialScan(body, kView, 75, 1, truth, 0.3);
  std::vector<int> still;
  Index displaced = 0;
  for (Index i = 0; i < scan.size(); ++i) {
    const Vector3d p = truth.inverse() * scan.points.row(i).transpose();
    if (p.x() < 25) {
      still.push_back(static_cast<int>(i));
      continue;
    }
    // The lobe beyond x = 25 mm is bent up, as packing does: up to 20 mm.
    scan.points.row(i) = (truth * (p + Vector3d(0, 0, 0.35 * (p.x() - 25)))).transpose();
    ++displaced;
  }
  ASSERT_NEAR(static_cast<double>(displaced) / static_cast<double>(scan.size()), 0.33, 0.1);
  const PreparedPreop preop(body);
  const Isometry3d start = startNear(scan, truth.inverse());
  RegistrationSettings plain;
  plain.robustScaleMm = 0;
  const ClosestOnPreop surface(preop);
  const PatchIcpResult icp = runClosestPointLoop(
      scan.points, [&](const Points& moved, Points& matched) { surface.closest(moved, matched); }, plain,
      start);
  const PatchIcpResult dirr = registerDirr(preop, scan, {}, start);
  const Points undeformed = rowsOf(scan.points, still);
  const double icpError = placedApart(undeformed, icp.preopFromScan, truth.inverse());
  const double dirrError = placedApart(undeformed, dirr.preopFromScan, truth.inverse());
  EXPECT_LT(dirrError, 3);  // mm, at the worst point: near the hinge the bend is within the scale of 2 mm
  EXPECT_GT(icpError, 2 * dirrError);
}

TEST(ClosestPointTransform, GivesTheClosestPointAtItsNodesAndNearlyBetween) {
  const Surface ball = test::sphere(50, 5);
  const LabelledTarget target(ball, {});
  const ClosestPointTransform map(target, 4, 20);
  for (Index i = 0; i < ball.size(); i += 37)
    for (const double radius : {38.0, 50.0, 57.0, 66.0}) {
      const Vector3d query = radius / 50 * ball.points.row(i).transpose();
      // The exact place is the vertex i. Nodes 4 mm apart see vertices 3 mm apart: half an edge and the
      // sagitta of a cell.
      EXPECT_LT((map.closest(query) - ball.points.row(i).transpose()).norm(), 2.5) << i << " at " << radius;
    }
}

TEST(ClosestPointTransform, AtTheMedialAxisItChoosesASide) {
  const Surface ball = test::sphere(50, 4);
  const ClosestPointTransform map(LabelledTarget(ball, {}), 4, 20);
  EXPECT_NEAR(map.closest(Vector3d(0.7, -0.4, 0.2)).norm(), 50, 1e-9);  // mm: a vertex, not the mean of eight
}

TEST(ClosestPointTransform, StaysWithinItsMemoryAndAnswersOutside) {
  Surface wide = test::sphere(3000, 3);
  const ClosestPointTransform map(LabelledTarget(wide, {}), 3, 30);
  EXPECT_GT(map.voxelMm(), 30);
  EXPECT_NEAR(map.closest(Vector3d(0, 0, 1e6)).norm(), 3000, 100);
}

TEST(ClosestPointTransform, IcpOnItRecoversANearbyPose) {
  const Surface body = lumpyBody(5);
  const Isometry3d truth = randomMotion(3);
  const Surface scan = partialScan(body, kView, 70, 3, truth);
  const Isometry3d start = startNear(scan, truth.inverse());
  const PatchIcpResult run = registerClosestPointTransform(PreparedPreop(body), scan, {}, start);
  // Interpolated between vertices 3 mm apart: within about an edge.
  EXPECT_LT(placedApart(scan.points, run.preopFromScan, truth.inverse()), 4);
  EXPECT_GT(placedApart(scan.points, start, truth.inverse()), 15);
}

TEST(ColourIcp, HoldsATexturedSphereThatShapeLetsSlide) {
  Surface ball = test::sphere(60, 4);
  paintTexture(ball);
  const Isometry3d truth = randomMotion(4);
  Surface scan = partialScan(ball, kView, 60, 1, truth, 0.3);
  Points origins = transformed(scan.points, truth.inverse());
  Surface seen;
  seen.points = origins;
  paintTexture(seen);
  scan.colours = seen.colours;
  const Isometry3d start = startNear(scan, truth.inverse(), 12);
  const auto error = [&](const PatchIcpResult& run) {
    return placedApart(scan.points, run.preopFromScan, truth.inverse());
  };
  const PreparedPreop preop(ball);
  RegistrationSettings icp;
  icp.method = RegistrationMethod::Icp;
  const PatchIcpResult plain = runPatchIcp(
      preop.target(), {scan.points, std::vector<int>(static_cast<std::size_t>(scan.size()))}, icp, start);
  EXPECT_GT(error(plain), 6);                                      // mm: slid nowhere
  EXPECT_LT(error(registerColourIcp(preop, scan, {}, start)), 2);  // mm: half an edge of 4 mm
}

TEST(ColourIcp, WithoutTextureItIsIcpAndWithoutColoursAnError) {
  Surface body = lumpyBody(4);
  const Isometry3d truth = randomMotion(3);
  Surface scan = partialScan(body, kView, 70, 1, truth, 0.5);
  const Isometry3d start = startNear(scan, truth.inverse());
  try {
    (void)registerColourIcp(PreparedPreop(body), scan, {}, start);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("pre-op surface has no colours"));
  }
  body.colours = Colours::Constant(body.size(), 3, 90);
  EXPECT_THROW((void)registerColourIcp(PreparedPreop(body), scan, {}, start), InputError);
  scan.colours = Colours::Constant(scan.size(), 3, 200);
  RegistrationSettings icp;
  icp.method = RegistrationMethod::Icp;
  const PreparedPreop preop(body);
  const PatchIcpResult plain = runPatchIcp(
      preop.target(), {scan.points, std::vector<int>(static_cast<std::size_t>(scan.size()))}, icp, start);
  EXPECT_LT(
      placedApart(scan.points, registerColourIcp(preop, scan, {}, start).preopFromScan, plain.preopFromScan),
      0.05);  // mm: both stop when a step is below 1e-3
}

using Method = PatchIcpResult (*)(const PreparedPreop&, const Surface&, const RegistrationSettings&,
                                  const Isometry3d&, const Progress&, const IterationObserver&);

class OtherRigidMethod : public testing::TestWithParam<Method> {
 protected:
  OtherRigidMethod() {
    paintTexture(body);
    scan = partialScan(body, kView, 70, 1, randomMotion(3), 0.5);
    scan.colours = body.colours.topRows(scan.size());
    start = startNear(scan, randomMotion(3).inverse());
  }
  Surface body = lumpyBody(4), scan;
  Isometry3d start;
};

TEST_P(OtherRigidMethod, GivesTheSameBitsForAnyNumberOfThreads) {
  const PreparedPreop preop(body);
  setThreads(1);
  const PatchIcpResult one = GetParam()(preop, scan, {}, start, {}, {});
  setThreads(4);
  const PatchIcpResult four = GetParam()(preop, scan, {}, start, {}, {});
  setThreads(0);
  EXPECT_EQ(one.preopFromScan.matrix(), four.preopFromScan.matrix());
  EXPECT_EQ(one.history.size(), four.history.size());
}

TEST_P(OtherRigidMethod, TellsEachIterationAndStopsWhenAsked) {
  const PreparedPreop preop(body);
  int seen = 0;
  const PatchIcpResult run = GetParam()(preop, scan, {}, start, {}, [&](const IterationRecord& record) {
    EXPECT_EQ(record.iteration, ++seen);
    EXPECT_GT(record.rmsMm, 0);
  });
  EXPECT_EQ(run.history.size(), static_cast<std::size_t>(seen));
  EXPECT_LT(run.history.back().rmsMm, run.history.front().rmsMm);
  EXPECT_EQ(run.history.back().preopFromScan.matrix(), run.preopFromScan.matrix());
  std::stop_source stop;
  EXPECT_THROW((void)GetParam()(preop, scan, {}, start, Progress({}, stop.get_token()),
                                [&](const IterationRecord& r) {
                                  if (r.iteration == 2) stop.request_stop();
                                }),
               Cancelled);
  RegistrationSettings brief;
  brief.maxIterations = 2;
  const PatchIcpResult cut = GetParam()(preop, scan, brief, start, {}, {});
  EXPECT_EQ(cut.history.size(), 2u);
  EXPECT_FALSE(cut.converged);
}

INSTANTIATE_TEST_SUITE_P(All, OtherRigidMethod,
                         testing::Values(&registerDirr, &registerClosestPointTransform, &registerColourIcp));

}  // namespace
}  // namespace falciform
