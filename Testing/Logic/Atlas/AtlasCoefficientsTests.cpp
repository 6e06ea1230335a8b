#include <gtest/gtest.h>

#include "Logic/Atlas/AtlasCoefficients.h"
#include "Logic/Atlas/SimplexLeastSquares.h"
#include "Logic/Core/Draws.h"

namespace falciform::test {
namespace {

Eigen::MatrixXd drawn(Index rows, Index columns, std::uint64_t seed) {
  Draws draws(seed);
  Eigen::MatrixXd matrix(rows, columns);
  for (Index i = 0; i < rows; ++i)
    for (Index k = 0; k < columns; ++k) matrix(i, k) = draws.normal();
  return matrix;
}

/// 9 members of 4 modes; the members and equations are all that the solutions look at.
Atlas nineMembers() {
  Atlas atlas;
  atlas.coefficients = drawn(9, 4, 3);
  return atlas;
}

ModalEquations equationsOf(const Eigen::MatrixXd& modes, const VectorXd& distances) {
  ModalEquations equations{.square = modes.transpose() * modes, .right = modes.transpose() * distances};
  equations.relativeError = 0.3;
  return equations;
}

double cost(const Eigen::MatrixXd& h, const VectorXd& g, const VectorXd& x) {
  return 0.5 * x.dot(h * x) - g.dot(x);
}

TEST(AtlasCoefficients, TikhonovAmongModesIsTikhonovAmongMembers) {
  const Atlas atlas = nineMembers();
  const Eigen::MatrixXd modes = drawn(60, 4, 5);
  const VectorXd distances = drawn(60, 1, 6);
  const ModalEquations equations = equationsOf(modes, distances);
  const AtlasCoefficients found = tikhonovCoefficients(atlas, equations, 0.01);
  // Eq. (V.16) as printed in the errata, 9 x 9.
  const Eigen::MatrixXd s = modes * atlas.coefficients.transpose(), square = s.transpose() * s;
  const double betaSquared = 0.01 * square.diagonal().mean() * 0.3 * 0.3;
  const VectorXd phi =
      (square + betaSquared * Eigen::MatrixXd::Identity(9, 9)).ldlt().solve(s.transpose() * distances);
  EXPECT_LT((found.members - phi).norm(), 1e-10 * phi.norm());  // rounding
  EXPECT_LT((found.modes - atlas.coefficients.transpose() * phi).norm(), 1e-10 * found.modes.norm());
}

TEST(AtlasCoefficients, ConstrainedSharesAreThoseOfASimplexAndHoldItsKnownPoint) {
  Atlas atlas;
  atlas.coefficients = drawn(4, 4, 8);  // as many members as modes: shares are unique
  const Eigen::MatrixXd modes = drawn(60, 4, 5);
  const VectorXd shares = Eigen::Vector4d(0.2, 0, 0.5, 0.1);
  const AtlasCoefficients inside =
      constrainedCoefficients(atlas, equationsOf(modes, modes * atlas.coefficients.transpose() * shares));
  EXPECT_LT((inside.members - shares).cwiseAbs().maxCoeff(), 1e-6);  // the hair of damping
  const AtlasCoefficients beyond = constrainedCoefficients(
      atlas, equationsOf(modes, modes * atlas.coefficients.transpose() * (3 * shares)));
  EXPECT_NEAR(beyond.members.sum(), 1, 1e-9);
  EXPECT_GE(beyond.members.minCoeff(), 0);
}

TEST(AtlasCoefficients, StatisticsWithoutAScanGiveTheMeanAndWithAnExactOneTheTruth) {
  const Atlas atlas = nineMembers();
  const MemberStatistics statistics(atlas, 1);
  EXPECT_EQ(statistics.components(), 4);
  const Eigen::MatrixXd modes = drawn(60, 4, 5);
  const VectorXd truth = Eigen::Vector4d(0.5, -1, 0.3, 0.8);
  ModalEquations equations = equationsOf(modes, modes * truth);
  equations.pointVariance = 1e12;
  EXPECT_LT((statistics.mostProbable(equations).modes - statistics.mean()).norm(), 1e-9);
  equations.pointVariance = 1e-12;
  EXPECT_LT((statistics.mostProbable(equations).modes - truth).norm(), 1e-9);
}

TEST(AtlasCoefficients, FewComponentsHoldTheShareOfVarianceThatIsAsked) {
  Atlas atlas = nineMembers();
  atlas.coefficients.col(0) *= 100;  // one direction has nearly all of it
  EXPECT_EQ(MemberStatistics(atlas, 0.95).components(), 1);
  atlas.coefficients.rowwise() = atlas.coefficients.row(0).eval();
  EXPECT_EQ(MemberStatistics(atlas, 0.95).components(), 0);  // members that do not differ
}

TEST(SimplexLeastSquares, NoPointOfTheSimplexIsBetter) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Eigen::MatrixXd a = drawn(12, 7, seed);
    const Eigen::MatrixXd h = a.transpose() * a;
    const VectorXd g = 3 * drawn(7, 1, seed + 100);
    const VectorXd x = simplexLeastSquares(h, g);
    ASSERT_GE(x.minCoeff(), 0);
    ASSERT_LE(x.sum(), 1 + 1e-12);
    // Convex: it is the minimum if the cost rises towards every corner, the origin among them.
    const VectorXd slope = h * x - g;
    EXPECT_GE(-slope.dot(x), -1e-9) << seed;
    for (Index k = 0; k < 7; ++k) EXPECT_GE(slope[k] - slope.dot(x), -1e-9) << seed;
    Draws draws(seed + 200);
    for (int trial = 0; trial < 200; ++trial) {
      VectorXd y(7);
      for (double& value : y) value = draws.uniform();
      y *= draws.uniform() / y.sum();
      EXPECT_LE(cost(h, g, x), cost(h, g, y) + 1e-12);
    }
  }
}

TEST(SimplexLeastSquares, WhatLiesInsideIsTheFreeMinimum) {
  const Eigen::MatrixXd a = drawn(12, 3, 4);
  const Eigen::MatrixXd h = a.transpose() * a;
  const VectorXd wanted = Vector3d(0.3, 0.2, 0.1);
  EXPECT_LT((simplexLeastSquares(h, h * wanted) - wanted).norm(), 1e-12);
  EXPECT_EQ(simplexLeastSquares(h, -h.cwiseAbs().rowwise().sum()), VectorXd(VectorXd::Zero(3)));
}

}  // namespace
}  // namespace falciform::test
