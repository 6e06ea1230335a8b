#pragma once
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// Figures of a sample; NaN where there is no value (the spread: fewer than two).
struct SampleStatistics {
  Index count = 0;
  double mean = 0, sd = 0;  ///< sd with n - 1
  double median = 0, p95 = 0, p99 = 0, max = 0;
};

/// Of the finite values; quantiles interpolate linearly between order statistics (Hyndman and Fan's type 7).
[[nodiscard]] SampleStatistics sampleStatistics(std::vector<double> values);

}  // namespace falciform
