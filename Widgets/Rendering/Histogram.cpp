#include "Widgets/Rendering/Histogram.h"

#include <algorithm>
#include <cmath>

namespace falciform {

double binWidth(double low, double high) {
  const double wanted = (high - low) / 40;
  if (!(wanted > 0) || !std::isfinite(wanted)) return 1;
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double step : {1.0, 2.0, 5.0})
    if (wanted <= step * decade * (1 + 1e-9)) return step * decade;
  return 10 * decade;
}

Histogram histogramOf(const VectorXd& values, double low, double high, double width) {
  const double first = std::floor(low / width + 1e-9);
  const auto bins = static_cast<long>(std::max(1.0, std::ceil(high / width - 1e-9) - first));
  Histogram histogram{first * width, width, std::vector<double>(static_cast<std::size_t>(bins), 0.0)};
  Index count = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    const double at = std::clamp(std::floor(value / width) - first, 0.0, static_cast<double>(bins - 1));
    histogram.shares[static_cast<std::size_t>(at)] += 1;
    ++count;
  }
  if (count > 0)
    for (double& share : histogram.shares) share /= static_cast<double>(count);
  return histogram;
}

}  // namespace falciform
