#include "Logic/Registration/Trials/Proportion.h"

#include <limits>

#include "Logic/Core/IncompleteBeta.h"

namespace falciform {

namespace {

/// The p at which `tail`, rising in p, reaches `level`.
template <class Tail>
double solve(const Tail& tail, double level) {
  double low = 0, high = 1;
  for (int step = 0; step < 200 && high - low > std::numeric_limits<double>::epsilon() * high; ++step) {
    const double middle = (low + high) / 2;
    (tail(middle) < level ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// The chance p at which k or more successes of n happen with probability `level`.
double lowerBound(double k, double n, double level) {
  if (k == 0) return 0;
  return solve([&](double p) { return incompleteBeta(k, n - k + 1, p); }, level);
}

}  // namespace

ProportionInterval proportionInterval(Index successes, Index trials, double confidence) {
  if (trials == 0) return {};
  const auto k = static_cast<double>(successes), n = static_cast<double>(trials);
  const double alpha = 1 - confidence;
  // The upper bound for successes is 1 - the lower bound for failures.
  return {lowerBound(k, n, alpha / 2), 1 - lowerBound(n - k, n, alpha / 2), lowerBound(k, n, alpha)};
}

}  // namespace falciform
