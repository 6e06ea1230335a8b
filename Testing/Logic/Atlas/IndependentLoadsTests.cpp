#include <gtest/gtest.h>

#include "Logic/Atlas/IndependentLoads.h"
#include "Logic/Core/Draws.h"

namespace falciform::test {
namespace {

Eigen::MatrixXd drawn(int rows, int columns, unsigned seed) {
  Draws draws(seed);
  Eigen::MatrixXd matrix(rows, columns);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) matrix(r, c) = draws.normal();
  return matrix;
}

void expectSums(const Eigen::MatrixXd& loads, Eigen::Index rank) {
  const IndependentLoads independent = independentLoads(loads);
  EXPECT_EQ(independent.basis.rows(), rank);
  EXPECT_EQ(independent.coefficients.cols(), rank);
  // Rounding of numbers of size 1.
  EXPECT_LT((independent.coefficients * independent.basis - loads).norm(), 1e-11);
}

TEST(IndependentLoads, SumUpToEveryLoadOfAnyRank) {
  expectSums(drawn(121, 3, 1), 3);
  expectSums(drawn(30, 2, 2) * drawn(2, 4, 3), 2);
  expectSums(drawn(3, 4, 4), 3);
  expectSums(drawn(1, 4, 5), 1);
  expectSums(Eigen::MatrixXd::Zero(5, 4), 0);
  expectSums(Eigen::MatrixXd::Zero(0, 4), 0);
}

TEST(IndependentLoads, FullRankGivesUnitsAndTheLoadsOwnNumbers) {
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(9, 4);
  for (int k = 0; k < 9; ++k) loads(k, 0) = 5 * (k + 1);
  const IndependentLoads independent = independentLoads(loads);
  EXPECT_EQ(independent.basis, Eigen::RowVector4d(1, 0, 0, 0));
  EXPECT_EQ(independent.coefficients, loads.col(0));
}

TEST(IndependentLoads, ASmallUnitHidesNothing) {
  Eigen::MatrixXd loads = drawn(40, 4, 6);
  loads.col(2) *= 1e-14;
  EXPECT_EQ(independentLoads(loads).basis.rows(), 4);
}

}  // namespace
}  // namespace falciform::test
