#include "Logic/Registration/PowellMinimiser.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace falciform {

namespace {

constexpr int kMostExpansions = 30, kMostRefinements = 60;
constexpr double kGrowth = std::numbers::phi;
constexpr double kShare = 2 - std::numbers::phi;  // of the larger part, for a golden-section step

struct Bracket {
  double low, middle, high, middleValue;
  bool closed;  // the function is higher at both ends than in the middle
};

Bracket bracketFrom(const std::function<double(double)>& f, double zeroValue, double step) {
  double before = 0, here = step, hereValue = f(step);
  if (hereValue > zeroValue) {
    const double other = f(-step);
    if (other >= zeroValue) return {-step, 0, step, zeroValue, true};
    step = -step;
    here = step;
    hereValue = other;
  }
  for (int k = 0; k < kMostExpansions; ++k) {
    step *= kGrowth;
    const double next = here + step, nextValue = f(next);
    if (nextValue >= hereValue)
      return {std::min(before, next), here, std::max(before, next), hereValue, true};
    before = here;
    here = next;
    hereValue = nextValue;
  }
  return {before, here, here, hereValue, false};
}

}  // namespace

double minimiseAlongLine(const std::function<double(double)>& f, double valueAtZero, double step,
                         double tolerance, double& value) {
  const Bracket b = bracketFrom(f, valueAtZero, step);
  // Brent (1973): a parabola through the three best places, a golden-section step where it is not to be
  // trusted.
  double low = b.low, high = b.high, best = b.middle, second = best, third = best;
  double bestValue = b.middleValue, secondValue = bestValue, thirdValue = bestValue;
  double move = 0, moveBefore = 0;
  for (int k = 0; b.closed && k < kMostRefinements; ++k) {
    const double middle = (low + high) / 2;
    if (std::abs(best - middle) <= 2 * tolerance - (high - low) / 2) break;
    double p = 0, q = 0;
    if (std::abs(moveBefore) > tolerance) {
      const double r = (best - second) * (bestValue - thirdValue);
      const double s = (best - third) * (bestValue - secondValue);
      p = (best - third) * s - (best - second) * r;
      q = 2 * (s - r);
      if (q > 0) p = -p;
      q = std::abs(q);
    }
    if (q > 0 && std::abs(p) < std::abs(q * moveBefore / 2) && p > q * (low - best) &&
        p < q * (high - best)) {
      moveBefore = move;
      move = p / q;
    } else {
      moveBefore = best < middle ? high - best : low - best;
      move = kShare * moveBefore;
    }
    const double trial = best + (std::abs(move) >= tolerance ? move : std::copysign(tolerance, move));
    const double trialValue = f(trial);
    if (trialValue <= bestValue) {
      (trial < best ? high : low) = best;
      third = second, thirdValue = secondValue;
      second = best, secondValue = bestValue;
      best = trial, bestValue = trialValue;
      continue;
    }
    (trial < best ? low : high) = trial;
    if (trialValue <= secondValue || second == best) {
      third = second, thirdValue = secondValue;
      second = trial, secondValue = trialValue;
    } else if (trialValue <= thirdValue || third == best || third == second) {
      third = trial, thirdValue = trialValue;
    }
  }
  value = bestValue;
  return best;
}

PowellResult minimisePowell(const std::function<double(const VectorXd&)>& function, const VectorXd& start,
                            double firstStep, const PowellLimits& limits,
                            const std::function<void(const VectorXd&, double)>& afterSweep) {
  PowellResult result;
  result.point = start;
  result.value = function(start);
  result.evaluations = 1;
  Eigen::MatrixXd directions = Eigen::MatrixXd::Identity(start.size(), start.size());
  const auto search = [&](const VectorXd& direction) {  // returns what was gained
    const VectorXd from = result.point;
    const double before = result.value;
    const double along =
        minimiseAlongLine([&](double t) { return ++result.evaluations, function(from + t * direction); },
                          before, firstStep, limits.tolerance / 2, result.value);
    result.point = from + along * direction;
    return before - result.value;
  };
  while (result.sweeps < limits.maxSweeps && !result.converged) {
    const VectorXd sweepStart = result.point;
    const double sweepValue = result.value;
    double largestGain = 0;
    Index largest = 0;
    for (Index d = 0; d < directions.cols(); ++d)
      if (const double gain = search(directions.col(d)); gain > largestGain) largestGain = gain, largest = d;
    const VectorXd step = result.point - sweepStart;
    result.converged = step.size() == 0 || step.cwiseAbs().maxCoeff() < limits.tolerance;
    if (!result.converged) {
      // Powell's test: the step replaces the direction of the largest gain unless that direction did nearly
      // all, or the function already bends up along the step.
      const double beyond = function(result.point + step);
      ++result.evaluations;
      const double gained = sweepValue - result.value;
      const double bend = sweepValue - 2 * result.value + beyond;
      const double rest = gained - largestGain, drop = sweepValue - beyond;
      if (beyond < sweepValue && 2 * bend * rest * rest < largestGain * drop * drop) {
        const VectorXd direction = step.normalized();
        (void)search(direction);
        directions.col(largest) = directions.col(directions.cols() - 1);
        directions.col(directions.cols() - 1) = direction;
      }
    }
    ++result.sweeps;
    if (afterSweep) afterSweep(result.point, result.value);
  }
  return result;
}

}  // namespace falciform
