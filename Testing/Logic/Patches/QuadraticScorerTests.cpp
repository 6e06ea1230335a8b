#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "Logic/Core/Parallel.h"
#include "Logic/Patches/QuadraticScorer.h"

namespace falciform {
namespace {

constexpr Index kRows = 4000;

/// Rows of three numbers in [-1, 1].
Eigen::MatrixXd drawnNumbers(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> even(-1, 1);
  return Eigen::MatrixXd::NullaryExpr(kRows, 3, [&] { return even(random); });
}

/// Log-odds 1 + 2 x - 3 y z.
VectorXd trueOdds(const Eigen::MatrixXd& x) {
  return (1 + 2 * x.col(0).array() - 3 * x.col(1).array() * x.col(2).array()).matrix();
}

VectorXd drawnAnswers(const VectorXd& odds, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> even(0, 1);
  return odds.unaryExpr([&](double o) { return even(random) < 1 / (1 + std::exp(-o)) ? 1.0 : 0.0; });
}

TEST(QuadraticScorer, HasTheNumbersThenTheirProducts) {
  Eigen::MatrixXd numbers(1, 2);
  numbers << 2, 3;
  Eigen::RowVectorXd expected(5);
  expected << 2, 3, 4, 6, 9;
  EXPECT_EQ(quadraticTerms(numbers), expected);
}

TEST(QuadraticScorer, RecoversTheLogOddsThatTheAnswersWereDrawnFrom) {
  const Eigen::MatrixXd x = drawnNumbers(1);
  const VectorXd odds = trueOdds(x);
  const QuadraticScorer scorer = fitQuadraticScorer(x, drawnAnswers(odds, 2), VectorXd::Ones(kRows), 1);
  // 10 weights from 4000 yes or no: each is known to 0.1 to 0.2, so the odds of a place to about 0.2.
  EXPECT_LT((scorer.logOdds(x) - odds).cwiseAbs().mean(), 0.25);
}

TEST(QuadraticScorer, AWeightCountsLikeSoManyRows) {
  const Eigen::MatrixXd x = drawnNumbers(3);
  const VectorXd answers = drawnAnswers(trueOdds(x), 4);
  Eigen::MatrixXd twice(2 * kRows, 3);
  twice << x, x;
  VectorXd answersTwice(2 * kRows);
  answersTwice << answers, answers;
  const QuadraticScorer once = fitQuadraticScorer(x, answers, VectorXd::Constant(kRows, 2), 1);
  const QuadraticScorer both = fitQuadraticScorer(twice, answersTwice, VectorXd::Ones(2 * kRows), 1);
  // Newton's method stops at changes of the log-odds below 1e-2; its next step is then below 1e-4.
  EXPECT_LT((once.weights - both.weights).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(QuadraticScorer, StaysFiniteWhereOneNumberTellsAll) {
  const Eigen::MatrixXd x = drawnNumbers(5);
  const VectorXd answers = x.col(0).unaryExpr([](double v) { return v > 0 ? 1.0 : 0.0; });
  const QuadraticScorer scorer = fitQuadraticScorer(x, answers, VectorXd::Ones(kRows), 1);
  const VectorXd odds = scorer.logOdds(x);
  EXPECT_TRUE(odds.allFinite());
  EXPECT_TRUE(((odds.array() > 0) == (answers.array() > 0.5)).cast<double>().mean() > 0.99);
}

TEST(QuadraticScorer, DoesNotDependOnTheThreads) {
  const Eigen::MatrixXd x = drawnNumbers(6);
  const VectorXd answers = drawnAnswers(trueOdds(x), 7);
  const auto weights = [&](int count) {
    setThreads(count);
    const VectorXd result = fitQuadraticScorer(x, answers, VectorXd::Ones(kRows), 1).weights;
    setThreads(0);
    return result;
  };
  EXPECT_EQ(weights(1), weights(3));
}

}  // namespace
}  // namespace falciform
