#include "Logic/Patches/FeatureEnds.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {

constexpr Index kStepMm = 3;          ///< between ends that are tried
constexpr double kEvidenceMm = 50;    ///< length that EndsModel::evidence speaks of
constexpr double kSureOdds = 3;       ///< log-odds count up to here
constexpr double kLeastShare = 1e-4;  ///< of the likeliest pair: what is less likely is left out
constexpr double kLeastVariance = 1e-3;

}  // namespace

VectorXd endNumbers(const TracedLine& line, const Eigen::MatrixXd& places, double sizeMm,
                    const LineEnds& ends) {
  VectorXd numbers(2 * places.cols() + 1);
  numbers << places.row(ends.first).transpose(), places.row(ends.last).transpose(),
      (line.points.row(ends.last) - line.points.row(ends.first)).norm() / sizeMm;
  return numbers;
}

EndsModel fitEnds(const std::vector<VectorXd>& numbers, const std::vector<double>& weights, double share) {
  EndsModel model;
  double total = 0;
  model.mean = VectorXd::Zero(numbers.front().size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    model.mean += weights[i] * numbers[i];
    total += weights[i];
  }
  model.mean /= total;
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(model.mean.size(), model.mean.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    covariance += weights[i] / total * (numbers[i] - model.mean) * (numbers[i] - model.mean).transpose();
  const VectorXd variances = covariance.diagonal();
  covariance *= 1 - share;
  covariance.diagonal() = variances.array() + kLeastVariance;
  model.precision = covariance.inverse();
  return model;
}

LineEnds likelyEnds(const TracedLine& line, const Eigen::MatrixXd& places, double sizeMm,
                    const EndsModel& model) {
  const Index n = line.points.rows();
  VectorXd sum = VectorXd::Zero(n + 1);
  for (Index i = 0; i < n; ++i) sum[i + 1] = sum[i] + std::clamp(line.logOdds[i], -kSureOdds, kSureOdds);
  std::vector<LineEnds> pairs;
  std::vector<double> odds;
  for (Index i = 0; i < n; i += kStepMm)
    for (Index j = i + static_cast<Index>(model.shortestMm); j < n; j += kStepMm) {
      const VectorXd off = endNumbers(line, places, sizeMm, {i, j}) - model.mean;
      pairs.push_back({i, j});
      odds.push_back(model.evidence * (sum[j] - sum[i]) / kEvidenceMm - 0.5 * off.dot(model.precision * off));
    }
  if (pairs.empty()) return {0, std::max<Index>(n - 1, 0)};
  const double best = *std::max_element(odds.begin(), odds.end());
  std::vector<std::size_t> likely;
  for (std::size_t p = 0; p < pairs.size(); ++p)
    if (odds[p] - best > std::log(kLeastShare)) likely.push_back(p);
  VectorXd expected = VectorXd::Zero(static_cast<Index>(pairs.size()));
  forEachChunk(pairs.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      for (const std::size_t truth : likely) {
        const auto [a, b] = pairs[p];
        const auto [c, d] = pairs[truth];
        const auto common = static_cast<double>(std::max<Index>(0, std::min(b, d) - std::max(a, c)));
        expected[static_cast<Index>(p)] +=
            std::exp(odds[truth] - best) * common / static_cast<double>(std::max(b - a, d - c));
      }
  });
  Index chosen = 0;
  expected.maxCoeff(&chosen);
  return pairs[static_cast<std::size_t>(chosen)];
}

}  // namespace falciform
