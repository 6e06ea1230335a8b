#pragma once

namespace falciform {

/// The regularised incomplete beta function I_x(a, b), a and b > 0, x in [0, 1], to about 1e-14. The tails of
/// the binomial distribution (k or more successes of n at chance p: I_p(k, n - k + 1)) and of Student's t.
[[nodiscard]] double incompleteBeta(double a, double b, double x);

}  // namespace falciform
