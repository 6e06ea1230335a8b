#pragma once
#include <limits>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// Of a sample: NaN where there is no value.
struct SampleMoments {
  Index count = 0;
  double mean = std::numeric_limits<double>::quiet_NaN();
  double sd = std::numeric_limits<double>::quiet_NaN();  ///< with n - 1; of two values or more
};
[[nodiscard]] SampleMoments sampleMoments(const std::vector<double>& values);

/// Whether two means differ, by Student's t; NaN where it cannot be said: fewer than two values in a sample,
/// or no spread in either.
struct TTest {
  double t = std::numeric_limits<double>::quiet_NaN();
  double degrees = std::numeric_limits<double>::quiet_NaN();  ///< of freedom
  double p = std::numeric_limits<double>::quiet_NaN();        ///< two-sided
};

/// Both samples drawn from one spread (Student 1908).
[[nodiscard]] TTest pooledTTest(const SampleMoments& a, const SampleMoments& b);
/// Each with a spread of its own (Welch 1947; degrees of freedom of Satterthwaite).
[[nodiscard]] TTest welchTTest(const SampleMoments& a, const SampleMoments& b);

/// Chance that |T| >= |t| for Student's T with `degrees` > 0 degrees of freedom, not necessarily whole.
[[nodiscard]] double studentTwoSided(double t, double degrees);

}  // namespace falciform
