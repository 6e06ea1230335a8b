#include "Widgets/Views/PlotAxis.h"

#include <algorithm>
#include <cmath>

namespace falciform {

void PlotAxis::include(double value) {
  if (!std::isfinite(value) || (logarithmic_ && value <= 0)) return;
  low_ = std::min(low_, value);
  high_ = std::max(high_, value);
}

void PlotAxis::include(const QVector<double>& values) {
  for (const double value : values) include(value);
}

void PlotAxis::finish() {
  if (empty()) return;
  if (logarithmic_) {
    low_ = std::pow(10, std::floor(std::log10(low_)));
    high_ = std::pow(10, std::ceil(std::log10(high_)));
    if (high_ <= low_) high_ = 10 * low_;
    return;
  }
  if (high_ - low_ < 1e-12) high_ = low_ + 1;
  const double rough = (high_ - low_) / 4;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  step_ = power;
  for (const double round : {1.0, 2.0, 5.0, 10.0})
    if (round * power >= rough) {
      step_ = round * power;
      break;
    }
  low_ = step_ * std::floor(low_ / step_ + 1e-9);
  high_ = step_ * std::ceil(high_ / step_ - 1e-9);
}

double PlotAxis::share(double value) const {
  if (logarithmic_) return (std::log10(value) - std::log10(low_)) / (std::log10(high_) - std::log10(low_));
  return (value - low_) / (high_ - low_);
}

QVector<double> PlotAxis::ticks() const {
  QVector<double> ticks;
  if (empty()) return ticks;
  if (logarithmic_) {
    for (double tick = low_; tick <= high_ * 1.001; tick *= 10) ticks << tick;
    return ticks;
  }
  const int count = static_cast<int>(std::lround((high_ - low_) / step_));
  // Zero is made exact: -1.1e-16 is no label.
  for (int i = 0; i <= count; ++i) {
    const double tick = low_ + i * step_;
    ticks << (std::abs(tick) < 1e-9 * step_ ? 0.0 : tick);
  }
  return ticks;
}

}  // namespace falciform
