#include <gtest/gtest.h>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Sampling.h"
#include "Logic/Registration/NonRigidRegistration.h"
#include "Logic/Registration/PointRegistration.h"
#include "Testing/Logic/Registration/PartialScan.h"

namespace falciform {
namespace {

using test::lumpyBody;
using test::partialScan;
using test::placedApart;
using test::randomMotion;

const Vector3d kView(0.1, -0.6, 0.8);

using Method = NonRigidResult (*)(const PreparedPreop&, const Surface&, const RegistrationSettings&,
                                  const Isometry3d&, const Progress&, const IterationObserver&);

/// A lobe bent up smoothly, and its partial scan.
class NonRigidMethod : public testing::TestWithParam<Method> {
 protected:
  NonRigidMethod() {
    for (Index i = 0; i < truth.rows(); ++i) {
      const double x = std::max(0.0, truth(i, 0));
      truth(i, 2) += 18 * (x / 100) * (x / 100);
    }
    Surface bent = body;
    bent.points = truth;
    scan = partialScan(bent, kView, 75, 1, motion, 0.3);
    truth = transformed(truth, motion);
    for (Index i = 0; i < body.size(); ++i)
      if (bent.points.row(i).normalized().dot(kView.normalized()) > std::cos(70 * EIGEN_PI / 180))
        covered.push_back(static_cast<int>(i));
    start = motion.inverse() * Eigen::Translation3d(3, -2, 4) * Eigen::AngleAxisd(0.05, Vector3d::UnitY());
  }
  [[nodiscard]] double coveredError(const Points& warped) const {
    return (rowsOf(warped, covered) - rowsOf(truth, covered)).rowwise().norm().mean();
  }

  Surface body = lumpyBody(4), scan;
  Isometry3d motion = randomMotion(6), start;
  Points truth = body.points;
  std::vector<int> covered;
};

TEST_P(NonRigidMethod, BeatsTheBestRigidMotionWhereTheScanReaches) {
  const NonRigidResult result = GetParam()(PreparedPreop(body), scan, {}, start, {}, {});
  const Points seen = rowsOf(body.points, covered);
  const Isometry3d best = fitRigid(seen, rowsOf(truth, covered));  // what no rigid method can better
  const double rigid = targetErrors(seen, rowsOf(truth, covered), best).mean();
  EXPECT_LT(coveredError(result.warpedPreop), 0.75 * rigid) << "rigid " << rigid;
  EXPECT_GT(rigid, 1.5);  // mm: there was something to gain
}

TEST_P(NonRigidMethod, StaysSaneWhereTheScanDoesNotReach) {
  const NonRigidResult result = GetParam()(PreparedPreop(body), scan, {}, start, {}, {});
  const Points rigid = transformed(body.points, result.rigid.preopFromScan.inverse());
  // The bend is 18 mm at most; nowhere may the warp leave its rigid part by more.
  EXPECT_LT((result.warpedPreop - rigid).rowwise().norm().maxCoeff(), 18);
  const double everywhere = (result.warpedPreop - truth).rowwise().norm().mean();
  EXPECT_LT(everywhere, 8);  // mm: the far side hangs on the near side's pose
}

TEST_P(NonRigidMethod, LeavesARigidBodyRigid) {
  const Surface still = partialScan(body, kView, 75, 1, motion, 0.3);
  const NonRigidResult result = GetParam()(PreparedPreop(body), still, {}, start, {}, {});
  const Points moved = transformed(body.points, motion);
  EXPECT_LT((rowsOf(result.warpedPreop, covered) - rowsOf(moved, covered)).rowwise().norm().mean(), 2);  // mm
}

TEST_P(NonRigidMethod, TheWarpOfThePointsIsTheWarpedSurface) {
  const NonRigidResult result = GetParam()(PreparedPreop(body), scan, {}, start, {}, {});
  EXPECT_EQ(result.scanFromPreopWarp(body.points), result.warpedPreop);
}

TEST_P(NonRigidMethod, GivesTheSameBitsForAnyNumberOfThreads) {
  const PreparedPreop preop(body);
  setThreads(1);
  const NonRigidResult one = GetParam()(preop, scan, {}, start, {}, {});
  setThreads(4);
  const NonRigidResult four = GetParam()(preop, scan, {}, start, {}, {});
  setThreads(0);
  EXPECT_EQ(one.warpedPreop, four.warpedPreop);
  EXPECT_EQ(one.rigid.preopFromScan.matrix(), four.rigid.preopFromScan.matrix());
}

TEST_P(NonRigidMethod, TellsEachIterationAndStopsWhenAsked) {
  const PreparedPreop preop(body);
  int seen = 0;
  const auto count = [&](const IterationRecord& record) { EXPECT_EQ(record.iteration, ++seen); };
  const NonRigidResult result = GetParam()(preop, scan, {}, start, {}, count);
  EXPECT_TRUE(result.rigid.converged) << result.rigid.stopReason;
  EXPECT_EQ(result.rigid.history.size(), static_cast<std::size_t>(seen));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)GetParam()(preop, scan, {}, start, Progress({}, stop.get_token()), {}), Cancelled);
  RegistrationSettings brief;
  brief.maxIterations = 2;
  EXPECT_FALSE(GetParam()(preop, scan, brief, start, {}, {}).rigid.converged);
}

INSTANTIATE_TEST_SUITE_P(All, NonRigidMethod, testing::Values(&registerTpsIcp, &registerRobustPoints));

}  // namespace
}  // namespace falciform
