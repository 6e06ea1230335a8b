#include "Logic/Atlas/BentImages.h"

#include <gmock/gmock.h>

#include <set>

#include "Logic/Core/Parallel.h"
#include "Testing/Logic/Atlas/BentBlock.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {
namespace {

/// A left-handed, oblique, uneven grid of about 1.5 x 2 x 3 mm around the block.
Matrix4d obliqueGrid() {
  Matrix4d grid = Matrix4d::Identity();
  const Matrix3d turn = Eigen::AngleAxisd(0.4, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  grid.topLeftCorner<3, 3>() = turn * Vector3d(1.5, -2, 3).asDiagonal();
  grid.topRightCorner<3, 1>() = Vector3d(60, 40, 25) - grid.topLeftCorner<3, 3>() * Vector3d(65, 45, 25);
  return grid;
}
const Vector3i kSize(130, 90, 50);

/// Linear in place, so that trilinear interpolation makes no error of its own.
float ramp(const Vector3d& place) {
  return static_cast<float>(2 * place.x() - 3 * place.y() + 1.5 * place.z());
}

Image rampImage() {
  Image image{kSize, obliqueGrid(), {}};
  image.voxels.resize(static_cast<std::size_t>(kSize.prod()));
  for (int k = 0; k < kSize.z(); ++k)
    for (int j = 0; j < kSize.y(); ++j)
      for (int i = 0; i < kSize.x(); ++i) image.at(i, j, k) = ramp(image.world(Vector3d(i, j, k)));
  return image;
}

LabelMap chequers() {
  LabelMap map{kSize, obliqueGrid(), {}};
  map.voxels.resize(static_cast<std::size_t>(kSize.prod()));
  const std::array<std::uint16_t, 3> labels{3, 700, 65535};
  for (int k = 0; k < kSize.z(); ++k)
    for (int j = 0; j < kSize.y(); ++j)
      for (int i = 0; i < kSize.x(); ++i)
        map.at(i, j, k) = labels[static_cast<std::size_t>(i / 9 + j / 9 + k / 9) % 3];
  return map;
}

UpdateMap blockMap(double largestMm = 12, const Isometry3d& motion = Isometry3d::Identity()) {
  const BentBlock block = bentBlock(true, largestMm);
  return {block.mesh, block.displacements, motion};
}

TEST(DisplacementGrid, AVectorLeadsFromWhereTissueIsToWhereItWas) {
  const UpdateMap map = blockMap(12, randomMotion(3));
  const SampledGrid at = coarserGrid(kSize, obliqueGrid(), 6);
  const DisplacementGrid grid = sampleDisplacements(map, at.size, at.worldFromIndex);
  double largest = 0;
  for (int k = 0; k < at.size.z(); ++k)
    for (int j = 0; j < at.size.y(); ++j)
      for (int i = 0; i < at.size.x(); ++i) {
        const Vector3d now = grid.world(Vector3d(i, j, k)), vector = grid.at(i, j, k).cast<double>();
        // mm: the sampling's own tolerance, and single precision. The rigid motion has no part in it.
        EXPECT_LT((map.bentFromPreop(now + vector) - now).norm(), 2e-4);
        largest = std::max(largest, vector.norm());
      }
  EXPECT_NEAR(largest, 13, 3);
}

TEST(DisplacementGrid, TissueThatMovedUpPointsDown) {
  // The direction told once more without the map: a body shifted by (0, 0, 10) has vectors of (0, 0, -10).
  BentBlock block = bentBlock(false, 0);
  block.displacements.col(2).setConstant(10);
  const UpdateMap map(block.mesh, block.displacements, Isometry3d::Identity());
  Matrix4d world = Matrix4d::Identity();
  world.topRightCorner<3, 1>() = Vector3d(60, 40, 35);
  const DisplacementGrid grid = sampleDisplacements(map, {1, 1, 1}, world);
  EXPECT_LT((grid.at(0, 0, 0) - Eigen::Vector3f(0, 0, -10)).norm(), 1e-4F);
}

TEST(DisplacementGrid, ACoarserGridKeepsItsFirstCornerAndReachesItsLast) {
  const Matrix4d fine = obliqueGrid();
  const SampledGrid coarse = coarserGrid(kSize, fine, 5);
  EXPECT_EQ(coarse.worldFromIndex.col(3), fine.col(3));
  const Vector3d last = (coarse.worldFromIndex.inverse() * fine *
                         Vector3d(kSize.x() - 1, kSize.y() - 1, kSize.z() - 1).homogeneous())
                            .head<3>();
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LE(last[axis], coarse.size[axis] - 1 + 1e-9);
    EXPECT_GT(last[axis], coarse.size[axis] - 2);
  }
  EXPECT_EQ(coarserGrid(kSize, fine, 0).worldFromIndex, fine);
}

TEST(BentImage, AVoxelShowsWhatWasWhereItsTissueWas) {
  const UpdateMap map = blockMap();
  const Image ct = rampImage(), bent = bendImage(map, ct, -1000);
  const Matrix4d indexFromWorld = ct.worldFromIndex.inverse();
  double worstIn = 0, worstOut = 0;
  for (int k = 0; k < bent.size.z(); k += 3)
    for (int j = 0; j < bent.size.y(); j += 3)
      for (int i = 0; i < bent.size.x(); i += 3) {
        const PreopPlace was = map.preopFromBent(bent.world(Vector3d(i, j, k)));
        const Vector3d index = (indexFromWorld * was.preop.homogeneous()).head<3>();
        const bool reached =
            (index.array() >= 0).all() && (index.array() <= (kSize.array() - 1).cast<double>()).all();
        if (!reached) continue;
        const double error = std::abs(bent.at(i, j, k) - ramp(was.preop));
        (was.inside ? worstIn : worstOut) = std::max(was.inside ? worstIn : worstOut, error);
      }
  EXPECT_LT(worstIn, 1e-2);  // single precision of values up to 700
  // Displacements around the liver are trilinear on 3 mm: 0.15 mm where they bend most, times a slope of 4.
  EXPECT_LT(worstOut, 0.6);
}

TEST(BentImage, BeyondTheCtThereIsTheBackground) {
  const UpdateMap map = blockMap(60);
  Image ct = rampImage();
  const Image bent = bendImage(map, ct, -1024);
  EXPECT_GT(bent.voxels.size(), ct.voxels.size());  // the block was pushed out of the CT's grid
  EXPECT_EQ(*std::min_element(bent.voxels.begin(), bent.voxels.end()), -1024);
  const Matrix4d indexFromWorld = bent.worldFromIndex.inverse();
  for (const Vector3d& corner : {map.deformed().lowest(), map.deformed().highest()}) {
    const Vector3d index = (indexFromWorld * corner.homogeneous()).head<3>();
    EXPECT_TRUE((index.array() > -1).all() && (index.array() < bent.size.array().cast<double>()).all());
  }
}

TEST(BentImage, WithoutBendingNothingChanges) {
  const UpdateMap map = blockMap(0);
  const LabelMap labels = chequers(), bent = bendLabels(map, labels);
  EXPECT_EQ(bent.worldFromIndex, labels.worldFromIndex);
  EXPECT_EQ(bent.voxels, labels.voxels);
  const Image ct = rampImage(), same = bendImage(map, ct, 0);
  float worst = 0;
  for (std::size_t v = 0; v < ct.voxels.size(); ++v)
    worst = std::max(worst, std::abs(ct.voxels[v] - same.voxels[v]));
  EXPECT_LT(worst, 1e-2F);  // rounding of indices of 100, times 6 a voxel
}

TEST(BentLabels, OnlyLabelsThatWereThereAndEachInItsPlace) {
  const UpdateMap map = blockMap();
  const LabelMap labels = chequers(), bent = bendLabels(map, labels);
  EXPECT_THAT(std::set<std::uint16_t>(bent.voxels.begin(), bent.voxels.end()),
              testing::IsSubsetOf({0, 3, 700, 65535}));
  const Matrix4d indexFromWorld = labels.worldFromIndex.inverse();
  int wrong = 0, looked = 0;
  for (int k = 0; k < bent.size.z(); ++k)
    for (int j = 0; j < bent.size.y(); ++j)
      for (int i = 0; i < bent.size.x(); i += 2) {
        const PreopPlace was = map.preopFromBent(bent.world(Vector3d(i, j, k)));
        if (!was.inside) continue;
        const Vector3d index = (indexFromWorld * was.preop.homogeneous()).head<3>();
        const Vector3i nearest = (index.array() + 0.5).floor().cast<int>();
        ++looked;
        wrong += bent.at(i, j, k) != labels.at(nearest.x(), nearest.y(), nearest.z()) ? 1 : 0;
      }
  EXPECT_GT(looked, 10000);
  EXPECT_EQ(wrong, 0);
}

TEST(BentImage, InTheScansFrameItLiesWhereTheTissueIs) {
  const Isometry3d motion = randomMotion(4);
  const Image ct = rampImage(), moved = movedVolume(ct, motion);
  const Vector3d index(12, 30, 7);
  EXPECT_LT((moved.world(index) - motion * ct.world(index)).norm(), 1e-10);
  EXPECT_EQ(moved.voxels, ct.voxels);
}

TEST(BentImage, SameBitsForAnyNumberOfThreads) {
  const UpdateMap map = blockMap();
  const Image ct = rampImage();
  setThreads(1);
  const Image one = bendImage(map, ct, 0);
  setThreads(3);
  const Image three = bendImage(map, ct, 0);
  setThreads(0);
  EXPECT_EQ(one.voxels, three.voxels);
}

TEST(BentImage, BackgroundIsTheLeastValue) {
  Image ct{{2, 1, 1}, Matrix4d::Identity(), {40, -1024}};
  EXPECT_EQ(backgroundOf(ct), -1024);
  ct.voxels = {7, 9};
  EXPECT_EQ(backgroundOf(ct), 7);
}

}  // namespace
}  // namespace falciform::test
