#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "Logic/Deformation/DistanceMapping.h"

namespace falciform {

namespace {

/// The value below which `share` of the ascending values lie, straight between neighbours (Hyndman and Fan's
/// type 7).
double quantile(const std::vector<double>& ascending, double share) {
  const double place = share * static_cast<double>(ascending.size() - 1);
  const auto low = static_cast<std::size_t>(place);
  const std::size_t high = std::min(low + 1, ascending.size() - 1);
  return ascending[low] + (place - static_cast<double>(low)) * (ascending[high] - ascending[low]);
}

}  // namespace

DistanceStatistics distanceStatistics(const VectorXd& values) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> found;
  for (const double value : values)
    if (!std::isnan(value)) found.push_back(value);
  DistanceStatistics s;
  s.count = static_cast<Index>(found.size());
  if (found.empty()) {
    s.mean = s.sd = s.median = s.p95Absolute = s.min = s.max = s.rms = s.meanAbsolute = none;
    return s;
  }
  const auto n = static_cast<double>(found.size());
  for (const double d : found) {
    s.mean += d / n;
    s.rms += d * d / n;
    s.meanAbsolute += std::abs(d) / n;
  }
  s.rms = std::sqrt(s.rms);
  double spread = 0;
  for (const double d : found) spread += (d - s.mean) * (d - s.mean);
  s.sd = found.size() > 1 ? std::sqrt(spread / (n - 1)) : none;

  std::sort(found.begin(), found.end());
  s.min = found.front();
  s.max = found.back();
  s.median = quantile(found, 0.5);
  for (double& d : found) d = std::abs(d);
  std::sort(found.begin(), found.end());
  s.p95Absolute = quantile(found, 0.95);
  return s;
}

}  // namespace falciform
