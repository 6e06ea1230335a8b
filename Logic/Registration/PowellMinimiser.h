#pragma once
#include <functional>

#include "Logic/Core/Types.h"

namespace falciform {

/// When a search by Powell's method ends.
struct PowellLimits {
  double tolerance = 1e-3;  ///< ends when a sweep moves no parameter farther than this
  int maxSweeps = 100;
};

struct PowellResult {
  VectorXd point;
  double value = 0;
  int sweeps = 0;
  int evaluations = 0;
  bool converged = false;
};

/// A local minimum of `function` by Powell's method (1964): line searches along a set of directions, the one
/// that gained most replaced by the sweep's whole step when that keeps the set well spread. Needs no
/// derivative. `firstStep`: how far the first line search looks, in the parameters' unit, > 0. `afterSweep`
/// is called with the point and its value; what it throws ends the search. The parameters should be of one
/// scale.
[[nodiscard]] PowellResult minimisePowell(
    const std::function<double(const VectorXd&)>& function, const VectorXd& start, double firstStep,
    const PowellLimits& limits = {},
    const std::function<void(const VectorXd& point, double value)>& afterSweep = {});

/// The minimum of a function of one variable near 0: bracketed by steps that grow from `step`, then Brent's
/// method to `tolerance`. Returns the place; `value` is set to the function there. Where the function keeps
/// falling, the farthest place looked at.
[[nodiscard]] double minimiseAlongLine(const std::function<double(double)>& function, double valueAtZero,
                                       double step, double tolerance, double& value);

}  // namespace falciform
