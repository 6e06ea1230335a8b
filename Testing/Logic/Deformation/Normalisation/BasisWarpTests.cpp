#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "Testing/Logic/Deformation/Normalisation/RandomWarp.h"

namespace falciform::test {
namespace {

TEST(BasisWarp, IsTheSumOfItsFunctions) {
  const BasisWarp warp = randomWarp(1, 15, 3);
  const Points places = randomPlaces(2, 50);
  for (Index i = 0; i < places.rows(); ++i) {
    const Vector3d place = places.row(i).transpose();
    Vector3d sum = place;
    for (int z = 0; z < 5; ++z)
      for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 5; ++x)
          sum += wu((place - 15 * Vector3d(x, y, z)).norm() / 30) *
                 warp.coefficients.row(x + 5 * (y + 5 * z)).transpose();
    EXPECT_NEAR((warp.move(place) - sum).norm(), 0, 1e-12);
  }
}

TEST(BasisWarp, GradientIsItsDerivative) {
  const BasisWarp warp = randomWarp(3, 12, 2);
  const Points places = randomPlaces(4, 50);
  constexpr double kStep = 1e-4;  // mm; the difference's own error is of its square
  for (Index i = 0; i < places.rows(); ++i) {
    const Vector3d place = places.row(i).transpose();
    Matrix3d expected;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d step = kStep * Vector3d::Unit(axis);
      expected.col(axis) = (warp.move(place + step) - warp.move(place - step)) / (2 * kStep);
    }
    EXPECT_NEAR((warp.gradient(place) - expected).norm(), 0, 1e-7);
  }
}

/// However wild the coefficients were, what is left has det J > 0 between the places looked at too.
TEST(BasisWarp, LimitedCompressionLeavesNoFoldAnywhere) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    BasisWarp warp = randomWarp(seed, 10, 20);
    EXPECT_GT(warp.compression(), 1);
    warp.limitCompression(0.6);
    EXPECT_LE(warp.compression(), 0.6 + 1e-12);
    EXPECT_GT(warp.coefficients.norm(), 0);
    const Points places = randomPlaces(100 + seed, 20000);
    double least = 1;
    for (Index i = 0; i < places.rows(); ++i) {
      const Matrix3d gradient = warp.gradient(places.row(i).transpose());
      const Matrix3d symmetric = (gradient + gradient.transpose()) / 2;
      least = std::min(least, Eigen::SelfAdjointEigenSolver<Matrix3d>(symmetric).eigenvalues()[0]);
    }
    EXPECT_GT(least, 0.2) << seed;  // 0.4 at the places looked at
  }
}

TEST(BasisWarp, LeavesAWarpAloneThatCompressesLess) {
  BasisWarp warp = randomWarp(5, 20, 0.5);
  const Points before = warp.coefficients;
  ASSERT_LT(warp.compression(), 0.6);
  warp.limitCompression(0.6);
  EXPECT_EQ(warp.coefficients, before);
}

TEST(BasisWarp, MoveBackUndoesMove) {
  BasisWarp warp = randomWarp(6, 10, 20);
  warp.limitCompression(0.6);
  const Points places = randomPlaces(7, 2000);
  for (Index i = 0; i < places.rows(); ++i) {
    const Vector3d place = places.row(i).transpose();
    EXPECT_NEAR((warp.moveBack(warp.move(place)) - place).norm(), 0, 1e-6);
  }
}

}  // namespace
}  // namespace falciform::test
