#include "Logic/Registration/Trials/SampleStatistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace falciform {

namespace {

double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

SampleStatistics sampleStatistics(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  std::sort(values.begin(), values.end());
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  SampleStatistics s{static_cast<Index>(values.size()), none, none, none, none, none, none};
  if (values.empty()) return s;
  const auto n = static_cast<double>(values.size());
  const Eigen::Map<const VectorXd> sample(values.data(), s.count);
  s.mean = sample.mean();
  if (s.count > 1) s.sd = std::sqrt((sample.array() - s.mean).square().sum() / (n - 1));
  s.median = quantile(values, 0.5);
  s.p95 = quantile(values, 0.95);
  s.p99 = quantile(values, 0.99);
  s.max = values.back();
  return s;
}

}  // namespace falciform
