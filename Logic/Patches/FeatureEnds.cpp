#include "Logic/Patches/FeatureEnds.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace falciform {

namespace {

constexpr Index kStepMm = 3;        ///< between ends that are tried
constexpr double kEvidenceMm = 50;  ///< length that EndsModel::evidence speaks of
constexpr double kSureOdds = 3;     ///< log-odds count up to here
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
  VectorXd summed = VectorXd::Zero(n + 1);
  for (Index i = 0; i < n; ++i)
    summed[i + 1] = summed[i] + std::clamp(line.logOdds[i], -kSureOdds, kSureOdds);
  std::vector<LineEnds> pairs;
  std::vector<double> odds;
  for (Index i = 0; i < n; i += kStepMm)
    for (Index j = i + static_cast<Index>(model.shortestMm); j < n; j += kStepMm) {
      const VectorXd off = endNumbers(line, places, sizeMm, {i, j}) - model.mean;
      pairs.push_back({i, j});
      odds.push_back(model.evidence * (summed[j] - summed[i]) / kEvidenceMm -
                     0.5 * off.dot(model.precision * off));
    }
  if (pairs.empty()) return {0, std::max<Index>(n - 1, 0)};
  // How likely each point lies between the ends: every pair adds its share from its first point to its last.
  const double best = *std::max_element(odds.begin(), odds.end());
  VectorXd between = VectorXd::Zero(n + 1);
  double total = 0;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const double share = std::exp(odds[p] - best);
    between[pairs[p].first] += share;
    between[pairs[p].last + 1] -= share;
    total += share;
  }
  LineEnds ends{n, 0};
  double sum = 0;
  for (Index i = 0; i < n; ++i)
    if ((sum += between[i]) >= 0.5 * total) ends = {std::min(ends.first, i), i};
  if (ends.first < ends.last) return ends;
  return pairs[static_cast<std::size_t>(std::max_element(odds.begin(), odds.end()) - odds.begin())];
}

}  // namespace falciform
