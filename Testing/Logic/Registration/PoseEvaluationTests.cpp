#include "Logic/Registration/PoseEvaluation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/RigidSteps.h"
#include "Logic/Registration/RegistrationLogic.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {
namespace {

struct PoseEvaluation : testing::Test {
  Surface preop = lumpyBody(3);
  Isometry3d truth = randomMotion(11, 80);  // scan from preop
  Surface scan = transformed(preop, truth, "scanner");
  PreparedPreop prepared{preop};
  RegistrationSettings settings;

  [[nodiscard]] RegistrationResult at(const Isometry3d& pose) const {
    RegistrationResult result;
    result.scanFromPreop = pose;
    return evaluatePose(result, prepared, scan, settings);
  }
};

TEST_F(PoseEvaluation, GivesARegistrationsOwnPoseTheFiguresItHas) {
  const RegistrationResult found = registerSurfaces(prepared, scan, settings);
  const RegistrationResult again = evaluatePose(found, prepared, scan, settings);
  EXPECT_TRUE(again.scanFromPreop.isApprox(found.scanFromPreop, 0)) << "nothing moves";
  EXPECT_DOUBLE_EQ(again.rmsMm, found.rmsMm);
  EXPECT_DOUBLE_EQ(again.weightedRmsMm, found.weightedRmsMm);
  EXPECT_DOUBLE_EQ(again.p95Mm, found.p95Mm);
  EXPECT_DOUBLE_EQ(again.coverage, found.coverage);
  EXPECT_DOUBLE_EQ(again.expectedErrorMeanMm, found.expectedErrorMeanMm);
  EXPECT_EQ(again.patchRmsMm, found.patchRmsMm);
}

TEST_F(PoseEvaluation, OfTheTruthIsZeroAndOfAFarPlaceIsTheWayThere) {
  const RegistrationResult exact = at(truth);
  EXPECT_LT(exact.rmsMm, 1e-9);  // mm: the scan is the body itself, rounding alone remains
  EXPECT_DOUBLE_EQ(exact.coverage, 1);
  // From far enough every point is about as far from its nearest as the body was moved, give or take its
  // size.
  const double reach = (preop.points.rowwise() - preop.points.colwise().mean()).rowwise().norm().maxCoeff();
  const RegistrationResult far = at(shifted(truth, Vector3d(5000, 0, 0)));
  EXPECT_NEAR(far.rmsMm, 5000, 2 * reach);
  EXPECT_EQ(far.coverage, 0);
  EXPECT_FALSE(far.warnings.empty());
}

TEST_F(PoseEvaluation, KeepsWhatThePoseCameWith) {
  RegistrationResult pose;
  pose.scanFromPreop = truth;
  pose.stopReason = "set by hand";
  pose.warnings = {"a note"};
  pose.history.resize(3);
  const RegistrationResult result = evaluatePose(pose, prepared, scan, settings);
  EXPECT_EQ(result.stopReason, "set by hand");
  EXPECT_EQ(result.warnings.front(), "a note");
  EXPECT_EQ(result.history.size(), 3u);
  EXPECT_FALSE(result.converged);
  for (const std::string& warning : result.warnings)
    EXPECT_EQ(warning.find("did not settle"), std::string::npos) << "nothing was asked to settle";
}

TEST_F(PoseEvaluation, RefusesAScanOfTwoPoints) {
  scan.points.conservativeResize(2, 3);
  scan.triangles.resize(0, 3);
  scan.patch.resize(2);
  scan.normals.resize(0, 3);
  EXPECT_THROW((void)at(truth), InputError);
}

TEST_F(PoseEvaluation, AChosenBasinBecomesTheResultsOwn) {
  RegistrationResult result = at(truth);
  for (const unsigned seed : {0u, 1u, 2u})
    result.basins.push_back({seed == 0 ? truth : randomMotion(seed), 0.1 * (seed + 1), 1});
  result.expectedTargetErrorMm = [](const Vector3d&) { return 1.0; };
  const RegistrationResult other = withBasin(result, 2);
  EXPECT_TRUE(other.scanFromPreop.isApprox(result.basins[2].scanFromPreop, 0));
  EXPECT_TRUE(other.basins[0].scanFromPreop.isApprox(result.basins[2].scanFromPreop, 0));
  EXPECT_TRUE(other.basins[1].scanFromPreop.isApprox(result.basins[0].scanFromPreop, 0)) << "order kept";
  EXPECT_FALSE(other.expectedTargetErrorMm) << "what was known of the old pose does not hold of this one";
  EXPECT_NE(other.warnings.at(0).find("chosen by the user"), std::string::npos);
  EXPECT_THROW((void)withBasin(result, 3), std::out_of_range);
}

TEST_F(PoseEvaluation, ARegistrationFromAGivenPoseStaysThereWhateverTheMethodSaysOfStarts) {
  Case document;
  Surface bare = preop, bareScan = scan;
  bare.patch.clear();
  bareScan.patch.clear();
  document.setPreop(std::make_shared<const Surface>(bare));
  document.setScan(std::make_shared<const Surface>(bareScan));
  RegistrationLogic logic(document);
  const Vector3d middle = preop.points.colwise().mean();
  const Isometry3d near = turned(truth, middle, Vector3d::UnitZ(), 0.05);  // 3 degrees
  for (const RegistrationMethod method : {RegistrationMethod::Auto, RegistrationMethod::Picp}) {
    logic.settings.method = method;
    const RegistrationResult result = logic.prepareFrom(near)({});
    EXPECT_LT(result.rmsMm, 0.05);  // mm; the minimum is exact, the finish stops at motions of 0.02 mm
    EXPECT_NEAR(result.rotationDeg, 0.05 * 180 / EIGEN_PI, 0.1) << "reported against the pose given";
    EXPECT_EQ(result.basins.size(), 1u);
  }
}

TEST(RigidSteps, TurningLeavesThePivotAndShiftingTheRotation) {
  const Isometry3d pose = randomMotion(5, 40);
  const Vector3d pivot(3, -7, 11), axis = Vector3d(1, 2, -1).normalized();
  const Isometry3d after = turned(pose, pivot, axis, 0.7);
  EXPECT_LT((after * pivot - pose * pivot).norm(), 1e-12);  // mm, rounding
  EXPECT_NEAR(Eigen::AngleAxisd(after.linear() * pose.linear().transpose()).angle(), 0.7, 1e-12);
  const Isometry3d aside = shifted(pose, {1, 2, 3});
  EXPECT_TRUE(aside.linear() == pose.linear());
  EXPECT_LT((aside * pivot - pose * pivot - Vector3d(1, 2, 3)).norm(), 1e-12);
}

TEST(RigidSteps, ManySmallTurnsAddUpToOneAndRemainARotation) {
  const Isometry3d pose = randomMotion(6, 40);
  const Vector3d pivot(10, 20, 30), axis = Vector3d(0, 1, 1).normalized();
  Isometry3d stepped = pose;
  for (int i = 0; i < 10000; ++i) stepped = turned(stepped, pivot, axis, 1e-4);
  EXPECT_LT((stepped.linear().transpose() * stepped.linear() - Matrix3d::Identity()).norm(), 1e-12);
  EXPECT_TRUE(stepped.isApprox(turned(pose, pivot, axis, 1), 1e-9));  // 10,000 roundings
}

TEST(PointRegistrationProblem, IsThereExactlyWhereRegisterPointsRefuses) {
  const auto list = [](std::initializer_list<Vector3d> places) {
    Landmarks all;
    for (const Vector3d& place : places) all.points.push_back({"", place});
    return all;
  };
  const Landmarks good = list({{0, 0, 0}, {50, 0, 0}, {0, 50, 0}});
  const Landmarks line = list({{0, 0, 0}, {50, 0, 0}, {100, 0, 0}});
  const Landmarks two = list({{0, 0, 0}, {50, 0, 0}});
  const Landmarks odd = list({{0, 0, 0}, {50, 0, 0}, {0, std::nan(""), 0}});
  for (const Landmarks* a : {&good, &line, &two, &odd})
    for (const Landmarks* b : {&good, &line, &two, &odd}) {
      const bool fine = a == &good && b == &good;
      EXPECT_EQ(pointRegistrationProblem(*a, *b).empty(), fine);
      if (fine)
        EXPECT_NO_THROW((void)registerPoints(*a, *b));
      else
        EXPECT_THROW((void)registerPoints(*a, *b), InputError);
    }
}

}  // namespace
}  // namespace falciform::test
