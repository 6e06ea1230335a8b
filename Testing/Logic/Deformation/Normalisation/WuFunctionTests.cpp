#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "Logic/Deformation/Normalisation/WuFunction.h"

namespace falciform::test {
namespace {

TEST(WuFunction, IsOneAtTheCentreAndZeroFromOneOn) {
  EXPECT_DOUBLE_EQ(wu(0), 1);
  EXPECT_DOUBLE_EQ(wu(1), 0);
  EXPECT_DOUBLE_EQ(wu(3), 0);
}

TEST(WuFunction, SlopeIsItsDerivativeAndBothMeetZeroSmoothly) {
  constexpr double kStep = 1e-5;
  for (double r = 0.01; r < 1.2; r += 0.01)
    EXPECT_NEAR(wuSlope(r) * r, (wu(r + kStep) - wu(r - kStep)) / (2 * kStep), 1e-8) << r;
  EXPECT_NEAR(wuSlope(1 - 1e-4), 0, 1e-9);  // C2: the slope leaves zero as the cube of the distance
}

TEST(WuFunction, IsPositiveDefiniteInSpace) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 1.5);
  for (int trial = 0; trial < 20; ++trial) {
    Eigen::Matrix3Xd points(3, 60);
    for (Eigen::Index i = 0; i < points.size(); ++i) points(i) = place(random);
    Eigen::MatrixXd gram(60, 60);
    for (Eigen::Index i = 0; i < 60; ++i)
      for (Eigen::Index j = 0; j < 60; ++j) gram(i, j) = wu((points.col(i) - points.col(j)).norm());
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(gram).eigenvalues()[0], 0) << trial;
  }
}

}  // namespace
}  // namespace falciform::test
