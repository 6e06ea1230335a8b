#include "Logic/Patches/QuadraticScorer.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {

constexpr Index kChunk = 512;
constexpr int kMostSteps = 12;
constexpr double kLargestChange =
    4;  ///< of any log-odds in one step, so that Newton's method cannot run away

double logistic(double x) { return 1 / (1 + std::exp(-std::clamp(x, -30.0, 30.0))); }

/// Z^T diag(w) Z, lower half, added up chunk by chunk in their order.
Eigen::MatrixXd weightedSquare(const Eigen::MatrixXd& z, const VectorXd& w) {
  const auto chunks = static_cast<std::size_t>((z.rows() + 8 * kChunk - 1) / (8 * kChunk));
  std::vector<Eigen::MatrixXd> parts(chunks);
  forEachChunk(chunks, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const Index first = static_cast<Index>(c) * 8 * kChunk, count = std::min(8 * kChunk, z.rows() - first);
      const Eigen::MatrixXd scaled =
          z.middleRows(first, count).transpose() * w.segment(first, count).cwiseSqrt().asDiagonal();
      parts[c] = Eigen::MatrixXd::Zero(z.cols(), z.cols());
      parts[c].selfadjointView<Eigen::Lower>().rankUpdate(scaled);
    }
  });
  Eigen::MatrixXd sum = parts.front();
  for (std::size_t c = 1; c < chunks; ++c) sum += parts[c];
  return sum;
}

}  // namespace

Eigen::MatrixXd quadraticTerms(const Eigen::MatrixXd& numbers) {
  const Index d = numbers.cols();
  Eigen::MatrixXd terms(numbers.rows(), d + d * (d + 1) / 2);
  terms.leftCols(d) = numbers;
  Index column = d;
  for (Index i = 0; i < d; ++i)
    for (Index j = i; j < d; ++j) terms.col(column++) = numbers.col(i).cwiseProduct(numbers.col(j));
  return terms;
}

VectorXd QuadraticScorer::logOdds(const Eigen::MatrixXd& numbers) const {
  VectorXd odds(numbers.rows());
  const VectorXd slope = weights.tail(weights.size() - 1);
  forEachChunk(static_cast<std::size_t>(numbers.rows()), kChunk, [&](std::size_t begin, std::size_t end) {
    const auto first = static_cast<Index>(begin), count = static_cast<Index>(end - begin);
    odds.segment(first, count) =
        (quadraticTerms(numbers.middleRows(first, count)) * slope).array() + weights[0];
  });
  return odds;
}

QuadraticScorer fitQuadraticScorer(const Eigen::MatrixXd& numbers, const VectorXd& yes,
                                   const VectorXd& weight, double penalty) {
  assert(numbers.rows() == yes.size() && yes.size() == weight.size() && numbers.rows() > 0);
  QuadraticScorer scorer;
  const Eigen::MatrixXd terms = quadraticTerms(numbers);
  const double total = weight.sum();
  const VectorXd mean = terms.transpose() * weight / total;
  Eigen::MatrixXd z(terms.rows(), terms.cols() + 1);
  z.col(0).setOnes();
  z.rightCols(terms.cols()) = terms.rowwise() - mean.transpose();
  const VectorXd spread =
      (z.rightCols(terms.cols()).cwiseAbs2().transpose() * weight / total).cwiseSqrt().cwiseMax(1e-9);
  for (Index t = 0; t < terms.cols(); ++t) z.col(t + 1) /= spread[t];

  VectorXd b = VectorXd::Zero(z.cols());
  VectorXd ridge = VectorXd::Constant(z.cols(), penalty);
  ridge[0] = 1e-9;
  for (int step = 0; step < kMostSteps; ++step) {
    const VectorXd p = (z * b).unaryExpr([](double x) { return logistic(x); });
    const VectorXd gradient = z.transpose() * weight.cwiseProduct(yes - p) - ridge.cwiseProduct(b);
    Eigen::MatrixXd hessian =
        weightedSquare(z, (weight.array() * p.array() * (1 - p.array()) + 1e-9).matrix());
    hessian.diagonal() += ridge;
    VectorXd change = hessian.selfadjointView<Eigen::Lower>().llt().solve(gradient);
    const double largest = (z * change).cwiseAbs().maxCoeff();
    if (largest > kLargestChange) change *= kLargestChange / largest;
    b += change;
    if (largest < 1e-2) break;  // log-odds: no decision turns on less
  }
  // Back from standardised terms to the terms themselves.
  scorer.weights = b;
  scorer.weights.tail(spread.size()) = b.tail(spread.size()).cwiseQuotient(spread);
  scorer.weights[0] -= mean.dot(scorer.weights.tail(spread.size()));
  return scorer;
}

}  // namespace falciform
