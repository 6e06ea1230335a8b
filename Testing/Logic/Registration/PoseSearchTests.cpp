#include "Logic/Registration/PoseSearch.h"

#include <gtest/gtest.h>

#include <numbers>

#include "Logic/Core/Parallel.h"
#include "Testing/Logic/Registration/PartialScan.h"

namespace falciform {
namespace {

using test::lumpyBody;
using test::partialScan;
using test::placedApart;
using test::randomMotion;

const Vector3d kView(0.1, -0.6, 0.8);

ScanSample sampleOf(const Surface& scan, bool labels) {
  LabelledSource source{scan.points, scan.patch};
  if (!labels) source.labels.assign(static_cast<std::size_t>(scan.size()), 0);
  return sampleScan(source, KdTree(scan.points), 300, 60);
}

TEST(RotationGrid, CoversAllRotationsEvenly) {
  for (const auto& [count, coveringDeg] : {std::pair(72, 60.0), std::pair(300, 36.0)}) {
    const std::vector<Matrix3d> grid = rotationGrid(count);
    double worst = 0;
    for (unsigned seed = 0; seed < 3000; ++seed) {
      const Matrix3d rotation = randomMotion(seed).linear();
      double nearest = 180;
      for (const Matrix3d& g : grid)
        nearest = std::min(nearest, Eigen::AngleAxisd(Matrix3d(g.transpose() * rotation)).angle() *
                                        (180 / std::numbers::pi));
      worst = std::max(worst, nearest);
    }
    EXPECT_LT(worst, coveringDeg) << count;
  }
}

TEST(ScanSample, LeavesStragglersOut) {
  Surface scan = partialScan(lumpyBody(5), kView, 60, 1, Isometry3d::Identity());
  const Index body = scan.size(), stragglers = 60;
  scan.points.conservativeResize(body + stragglers, 3);
  for (Index i = 0; i < stragglers; ++i)  // 25 mm apart, above the surface
    scan.points.row(body + i) =
        Eigen::RowVector3d(25.0 * static_cast<double>(i % 8), 25.0 * static_cast<double>(i / 8), 200);
  scan.patch.resize(static_cast<std::size_t>(scan.size()), 0);
  const ScanSample sample = sampleOf(scan, false);
  EXPECT_GT(sample.size(), 250);
  EXPECT_LT(sample.points.col(2).maxCoeff(), 199);
}

TEST(ScanSample, NormalsPointOutOfABulgingScan) {
  const Surface body = lumpyBody(5);
  const Isometry3d pose = randomMotion(3);
  const ScanSample sample = sampleOf(partialScan(body, kView, 60, 1, pose, 0.3), false);
  EXPECT_TRUE(sample.outward);
  int outward = 0;
  for (Index i = 0; i < sample.size(); ++i)
    outward += sample.normals.row(i).dot((sample.points.row(i).transpose() - pose.translation())) > 0;
  EXPECT_GT(outward, 0.95 * static_cast<double>(sample.size()));  // the body is star-shaped about its origin
}

TEST(ScanSample, AFlatScanDoesNotClaimToKnowItsOutside) {
  EXPECT_FALSE(sampleOf(test::grid(100, 60), false).outward);
}

TEST(PoseSearch, FindsThePoseFromPatchesAndFromTheBareSurface) {
  const PreparedPreop preop(lumpyBody(5));
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Isometry3d truth = randomMotion(seed, 300);
    const Surface scan = partialScan(preop.surface(), kView, 70, 2, truth, 0.5, seed);
    for (const bool labels : {true, false}) {
      const ScanSample sample = sampleOf(scan, labels);
      const std::vector<StartPose> found =
          labels ? startsFromPatches(preop, sample) : startsFromSurface(preop, sample);
      // The search is good to about a cell of its map; the finish does the rest.
      EXPECT_LT(placedApart(scan.points, found.front().preopFromScan, truth.inverse()), 8)
          << "seed " << seed << (labels ? " patches" : " bare");
    }
  }
}

TEST(PoseSearch, BasinsAreApartAndBestFirst) {
  const PreparedPreop preop(lumpyBody(4));
  const ScanSample sample = sampleOf(partialScan(preop.surface(), kView, 50, 1, randomMotion(1), 1), false);
  const std::vector<StartPose> found = startsFromSurface(preop, sample);
  ASSERT_GT(found.size(), 2u);
  const Points corners = boxCorners(sample.points);
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t j = i + 1; j < found.size(); ++j) {
      EXPECT_LE(found[i].score, found[j].score);
      EXPECT_GE(placedApart(corners, found[i].preopFromScan, found[j].preopFromScan), 10);
    }
}

TEST(PoseSearch, SameBitsForAnyNumberOfThreads) {
  const PreparedPreop preop(lumpyBody(4));
  const ScanSample sample = sampleOf(partialScan(preop.surface(), kView, 60, 1, randomMotion(2), 1), false);
  setThreads(1);
  const std::vector<StartPose> one = startsFromSurface(preop, sample);
  setThreads(3);
  const std::vector<StartPose> three = startsFromSurface(preop, sample);
  setThreads(0);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_EQ(one[i].preopFromScan.matrix(), three[i].preopFromScan.matrix());
}

}  // namespace
}  // namespace falciform
