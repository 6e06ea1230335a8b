#include "Logic/Registration/ElasticFit.h"

#include <gtest/gtest.h>

#include "Logic/Core/Parallel.h"
#include "Logic/Registration/PointRegistration.h"
#include "Testing/Logic/Registration/PartialScan.h"

namespace falciform {
namespace {

using test::lumpyBody;
using test::placedApart;

const Vector3d kView(0.1, -0.6, 0.8);

LabelledSource sourceOf(const Surface& scan, bool labels = true) {
  LabelledSource source{scan.points, scan.patch};
  if (!labels) std::fill(source.labels.begin(), source.labels.end(), 0);
  return source;
}

/// A motion of about 4 deg and 6 mm.
Isometry3d nearby() {
  Isometry3d off = Isometry3d::Identity();
  off.rotate(Eigen::AngleAxisd(0.07, Vector3d(1, 2, -1).normalized()));
  off.translation() = Vector3d(3, -4, 3);
  return off;
}

/// The body bent as livers are in packing: smooth, nearly without change of volume.
Surface bent(Surface body, double mm) {
  for (Index i = 0; i < body.size(); ++i) {
    const Vector3d p = body.points.row(i);
    body.points.row(i) += mm * Eigen::RowVector3d(0, 0.3 * std::sin(p.z() / 40), p.x() * p.x() / 3600);
  }
  return body;
}

TEST(ElasticFit, FindsARigidPoseWithinItsNoise) {
  const Surface body = lumpyBody(5);
  const PreparedPreop preop(body);
  const Isometry3d truth = test::randomMotion(3, 200);
  const Surface scan = test::partialScan(body, kView, 60, 1, truth, 0.5);
  ElasticFitPlan settings;
  settings.learn = true;
  const ElasticFitResult fit = fitElastic(preop, sourceOf(scan), settings, nearby() * truth.inverse());
  EXPECT_TRUE(fit.pose.converged);
  // 0.5 mm on some 1,800 points; the body's far side swings out by a few times the error where it is seen.
  EXPECT_LT(placedApart(body.points, fit.pose.preopFromScan.inverse(), truth), 0.6);
  EXPECT_LT(preop.modes().rootMeanSquare(fit.bending), 0.2);
  EXPECT_LT(fit.strain, 0.004);
}

TEST(ElasticFit, IsNotPulledAwayByWhatIsBent) {
  const Surface body = lumpyBody(5), moved = bent(body, 8);
  const PreparedPreop preop(body);
  // The pose of the organ as a whole: the best rigid motion of all its points.
  const Isometry3d truth = fitRigid(moved.points, body.points);
  const Surface scan = test::partialScan(moved, kView, 55, 1, Isometry3d::Identity(), 0.3);
  const auto errorOf = [&](double strain) {
    ElasticFitPlan settings;
    settings.strain = strain;
    const Isometry3d pose =
        fitElastic(preop, sourceOf(scan, false), settings, Isometry3d::Identity()).pose.preopFromScan;
    return (transformed(moved.points, pose) - transformed(moved.points, truth)).rowwise().norm().mean();
  };
  const double stiff = errorOf(1e-5), soft = errorOf(0.016);
  EXPECT_LT(soft, 0.6 * stiff) << "stiff " << stiff << " mm, soft " << soft << " mm";
}

TEST(ElasticFit, LearnsThatSomethingIsBentAndSaysSo) {
  const Surface body = lumpyBody(5);
  const PreparedPreop preop(body);
  ElasticFitPlan settings;
  settings.learn = true;
  const auto fitOf = [&](double mm) {
    const Surface scan = test::partialScan(bent(body, mm), kView, 60, 1, Isometry3d::Identity(), 0.3);
    return fitElastic(preop, sourceOf(scan), settings, Isometry3d::Identity());
  };
  const ElasticFitResult straight = fitOf(0), soft = fitOf(8);
  EXPECT_GT(soft.strain, 5 * straight.strain);
  const Vector3d place(0, 0, -40);  // not seen
  EXPECT_GT(expectedTargetError(preop.modes(), soft)(place),
            3 * expectedTargetError(preop.modes(), straight)(place));
}

TEST(ElasticFit, ExpectedErrorIsAboutTheTrueOne) {
  const Surface body = lumpyBody(5);
  const PreparedPreop preop(body);
  ElasticFitPlan settings;
  settings.learn = true;
  double expected = 0, error = 0;
  for (const double mm : {3.0, 6.0, 9.0, 12.0}) {
    const Surface moved = bent(body, mm);
    const ElasticFitResult fit =
        fitElastic(preop, sourceOf(test::partialScan(moved, kView, 60, 1, Isometry3d::Identity(), 0.5)),
                   settings, Isometry3d::Identity());
    const auto expectedAt = expectedTargetError(preop.modes(), fit);
    for (Index i = 0; i < body.size(); i += 10) {
      expected += std::pow(expectedAt(body.points.row(i)), 2);
      error += (fit.pose.preopFromScan * moved.points.row(i).transpose() - body.points.row(i).transpose())
                   .squaredNorm();
    }
  }
  // Four bends of one kind on one body: a factor of two is what such a sample can tell.
  EXPECT_GT(std::sqrt(expected / error), 0.5);
  EXPECT_LT(std::sqrt(expected / error), 2.0);
}

TEST(ElasticFit, OutliersDoNotMoveIt) {
  const Surface body = lumpyBody(5);
  const PreparedPreop preop(body);
  Surface scan = test::partialScan(body, kView, 60, 1, Isometry3d::Identity(), 0.3);
  for (Index i = 0; i < scan.size(); i += 8) scan.points.row(i) += 35 * kView.transpose();  // smoke in front
  const ElasticFitResult fit = fitElastic(preop, sourceOf(scan), {}, nearby());
  EXPECT_LT(placedApart(body.points, fit.pose.preopFromScan, Isometry3d::Identity()), 1);
}

TEST(ElasticFit, SameBitsForAnyNumberOfThreads) {
  const Surface body = lumpyBody(4);
  const PreparedPreop preop(body);
  const Surface scan = test::partialScan(body, kView, 60, 1, test::randomMotion(2), 1);
  const Isometry3d start = nearby() * test::randomMotion(2).inverse();
  setThreads(1);
  const ElasticFitResult one = fitElastic(preop, sourceOf(scan), {}, start);
  setThreads(3);
  const ElasticFitResult three = fitElastic(preop, sourceOf(scan), {}, start);
  setThreads(0);
  EXPECT_EQ(one.pose.preopFromScan.matrix(), three.pose.preopFromScan.matrix());
  EXPECT_EQ(one.bending, three.bending);
}

TEST(ElasticFit, StopsWhenAsked) {
  const Surface body = lumpyBody(3);
  const PreparedPreop preop(body);
  std::stop_source stop;
  const Progress progress([&](double, std::string_view) { stop.request_stop(); }, stop.get_token());
  EXPECT_THROW((void)fitElastic(preop, sourceOf(body), {}, nearby(), progress), Cancelled);
}

}  // namespace
}  // namespace falciform
