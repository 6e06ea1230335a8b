#pragma once
#include "Logic/Core/Types.h"

namespace falciform {

/// What k successes of n independent trials prove of the chance of success (Clopper and Pearson 1934): exact,
/// by the tails of the binomial distribution, so never too narrow.
struct ProportionInterval {
  double low = 0, high = 1;  ///< two-sided
  double atLeast = 0;        ///< one-sided lower bound: 250 of 250 prove >= 98.8 % at 95 %
};

/// `successes` in [0, trials]; 0 trials prove nothing: [0, 1]. `confidence` in (0, 1).
[[nodiscard]] ProportionInterval proportionInterval(Index successes, Index trials, double confidence = 0.95);

}  // namespace falciform
