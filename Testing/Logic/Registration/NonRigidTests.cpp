#include <gtest/gtest.h>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Sampling.h"
#include "Logic/Geometry/TriangleTree.h"
#include "Logic/Registration/NonRigidRegistration.h"
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

/// A body with a smooth dent of 12 mm in its seen side, as a retractor makes one, and its partial scan.
class NonRigidMethod : public testing::TestWithParam<Method> {
 protected:
  NonRigidMethod() {
    // Of another mesh of the same shape: no scan point is a vertex, and none knows its counterpart.
    Surface finer = lumpyBody(5);
    finer.points = dented(finer.points);
    scan = partialScan(finer, kView, 75, 4, motion, 0.3);
    for (Index i = 0; i < body.size(); ++i)
      if (truth.row(i).normalized().dot(kView.normalized()) > std::cos(70 * EIGEN_PI / 180))
        covered.push_back(static_cast<int>(i));
    truth = transformed(truth, motion);
    start = motion.inverse() * Eigen::Translation3d(3, -2, 4) * Eigen::AngleAxisd(0.05, Vector3d::UnitY());
  }
  [[nodiscard]] static Points dented(Points points) {
    const Eigen::RowVector3d in = -kView.normalized().transpose();
    for (Index i = 0; i < points.rows(); ++i)
      points.row(i) += 12 * std::exp(-(points.row(i) + 60 * in).squaredNorm() / (2 * 35 * 35)) * in;
    return points;
  }
  /// Mean over the seen vertices, mm.
  [[nodiscard]] double coveredError(const Points& warped) const {
    return (rowsOf(warped, covered) - rowsOf(truth, covered)).rowwise().norm().mean();
  }
  /// The same for the distance to the true surface: sliding along it is free.
  [[nodiscard]] double shapeError(const Points& warped) const {
    Surface there = body;
    there.points = truth;
    const TriangleTree tree(there);
    double sum = 0;
    for (const int i : covered) sum += tree.closest(warped.row(i).transpose()).distance;
    return sum / static_cast<double>(covered.size());
  }
  [[nodiscard]] Points byRigidIcp() const {
    RegistrationSettings icp;
    icp.method = RegistrationMethod::Icp;
    const LabelledSource source{scan.points, std::vector<int>(static_cast<std::size_t>(scan.size()))};
    const PreparedPreop preop(body);
    const PatchIcpResult run = runPatchIcp(preop.target(), source, icp, start);
    return transformed(body.points, run.preopFromScan.inverse());
  }

  Surface body = lumpyBody(4), scan;
  Isometry3d motion = randomMotion(6), start;
  Points truth = dented(body.points);
  std::vector<int> covered;
};

TEST_P(NonRigidMethod, RecoversADentWhereTheScanReaches) {
  const NonRigidResult result = GetParam()(PreparedPreop(body), scan, {}, start, {}, {});
  const Points rigid = byRigidIcp();
  // Closest points tell the shape, and little of what slides along it: hence two bounds.
  EXPECT_LT(shapeError(result.warpedPreop), 0.5 * shapeError(rigid)) << shapeError(rigid);
  EXPECT_LT(coveredError(result.warpedPreop), 0.95 * coveredError(rigid)) << coveredError(rigid);
  EXPECT_GT(shapeError(rigid), 1.5);  // mm: there was something to gain
}

TEST_P(NonRigidMethod, StaysSaneWhereTheScanDoesNotReach) {
  const NonRigidResult result = GetParam()(PreparedPreop(body), scan, {}, start, {}, {});
  const Points rigid = transformed(body.points, result.rigid.preopFromScan.inverse());
  // Nowhere may the warp leave its rigid part by more than the dent's 12 mm, and over the whole body, two
  // thirds of it unseen, it does no worse than rigid ICP.
  EXPECT_LT((result.warpedPreop - rigid).rowwise().norm().maxCoeff(), 14);
  EXPECT_LT((result.warpedPreop - truth).rowwise().norm().mean(),
            1.05 * (byRigidIcp() - truth).rowwise().norm().mean());
}

TEST_P(NonRigidMethod, LeavesARigidBodyRigid) {
  const Surface still = partialScan(lumpyBody(5), kView, 75, 4, motion, 0.3);
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
