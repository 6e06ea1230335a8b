#pragma once
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// Shares of the finite values in bins of equal width; bin i covers [low + i * width, low + (i + 1) * width).
struct Histogram {
  double low = 0, width = 1;
  std::vector<double> shares;  ///< sum to 1, or all 0 where there is no finite value
};

/// A bin width of 1, 2 or 5 x 10^k that gives `low` to `high` about 40 bins.
[[nodiscard]] double binWidth(double low, double high);

/// Bins start at a multiple of `width` and reach from `low` to `high`; values outside are counted in the
/// outermost bins.
[[nodiscard]] Histogram histogramOf(const VectorXd& values, double low, double high, double width);

}  // namespace falciform
