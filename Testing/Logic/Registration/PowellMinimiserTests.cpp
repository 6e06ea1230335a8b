#include "Logic/Registration/PowellMinimiser.h"

#include <gtest/gtest.h>

#include <cmath>

namespace falciform {
namespace {

TEST(MinimiseAlongLine, FindsTheVertexOfAParabolaOnEitherSide) {
  for (const double place : {-7.3, -0.02, 0.0, 0.4, 55.0}) {
    const auto f = [&](double t) { return 3 + 2 * (t - place) * (t - place); };
    double value = 0;
    EXPECT_NEAR(minimiseAlongLine(f, f(0), 1, 1e-6, value), place, 2e-6);  // twice the tolerance asked for
    EXPECT_NEAR(value, 3, 1e-10);
  }
}

TEST(MinimiseAlongLine, FindsAKinkAndAQuarticsFlatBottom) {
  double value = 0;
  const auto kink = [](double t) { return std::abs(t - 2.5); };
  EXPECT_NEAR(minimiseAlongLine(kink, kink(0), 1, 1e-5, value), 2.5, 2e-5);
  const auto quartic = [](double t) { return std::pow(t + 4, 4); };
  (void)minimiseAlongLine(quartic, quartic(0), 1, 1e-5, value);
  EXPECT_LT(value, 1e-10);  // the place is loose on a flat bottom, the value is not
}

TEST(MinimiseAlongLine, NeverEndsHigherThanItBegan) {
  for (int k = 0; k < 40; ++k) {
    const auto f = [&](double t) { return std::sin(1.7 * t + k) + 0.1 * std::cos(9 * t) + 0.01 * t * t; };
    double value = 0;
    const double place = minimiseAlongLine(f, f(0), 0.7, 1e-4, value);
    EXPECT_LE(value, f(0));
    EXPECT_EQ(value, f(place));
  }
}

TEST(MinimiseAlongLine, StopsWhereTheFunctionFallsForEver) {
  double value = 0;
  const auto f = [](double t) { return -t; };
  EXPECT_GT(minimiseAlongLine(f, 0, 1, 1e-6, value), 1e3);
  EXPECT_TRUE(std::isfinite(value));
}

TEST(MinimisePowell, SolvesASlantedQuadraticInAFewSweeps) {
  // A condition number of 400 along directions that are no axes: conjugate directions are found on the way.
  const Matrix3d turn = Eigen::AngleAxisd(0.8, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const Matrix3d form = turn * Vector3d(1, 20, 400).asDiagonal() * turn.transpose();
  const Vector3d answer(3, -5, 2);
  const auto f = [&](const VectorXd& x) { return (x - answer).dot(form * (x - answer)); };
  const PowellResult result = minimisePowell(f, VectorXd::Zero(3), 1, {1e-6, 100});
  EXPECT_TRUE(result.converged);
  EXPECT_LT((result.point - answer).norm(), 1e-4);
  EXPECT_LT(result.sweeps, 15);
}

TEST(MinimisePowell, FollowsRosenbrocksValley) {
  const auto f = [](const VectorXd& x) {
    return 100 * std::pow(x[1] - x[0] * x[0], 2) + std::pow(1 - x[0], 2);
  };
  VectorXd start(2);
  start << -1.2, 1;
  const PowellResult result = minimisePowell(f, start, 0.5, {1e-7, 500});
  EXPECT_TRUE(result.converged);
  EXPECT_LT((result.point - VectorXd::Ones(2)).norm(), 1e-4);
}

TEST(MinimisePowell, SurvivesPowellsSingularFunction) {
  const auto f = [](const VectorXd& x) {
    return std::pow(x[0] + 10 * x[1], 2) + 5 * std::pow(x[2] - x[3], 2) + std::pow(x[1] - 2 * x[2], 4) +
           10 * std::pow(x[0] - x[3], 4);
  };
  VectorXd start(4);
  start << 3, -1, 0, 1;
  EXPECT_LT(minimisePowell(f, start, 1, {1e-8, 1000}).value, 1e-8);  // from 215
}

TEST(MinimisePowell, KeepsItsLimitAndSaysSo) {
  int sweeps = 0;
  const auto f = [](const VectorXd& x) {
    return 100 * std::pow(x[1] - x[0] * x[0], 2) + std::pow(1 - x[0], 2);
  };
  double last = INFINITY;
  const PowellResult result =
      minimisePowell(f, VectorXd::Constant(2, -1), 0.5, {1e-9, 3}, [&](const VectorXd&, double value) {
        ++sweeps;
        EXPECT_LE(value, last);
        last = value;
      });
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.sweeps, 3);
  EXPECT_EQ(sweeps, 3);
  EXPECT_EQ(result.value, last);
}

}  // namespace
}  // namespace falciform
