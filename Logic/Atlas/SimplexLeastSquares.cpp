#include "Logic/Atlas/SimplexLeastSquares.h"

#include <Eigen/LU>
#include <vector>

namespace falciform {
namespace {

/// The minimum over the variables that may differ from 0, summing to 1; the multiplier of that sum is last.
VectorXd solveFree(const Eigen::MatrixXd& hessian, const VectorXd& gradient, const std::vector<int>& free) {
  const auto n = static_cast<Index>(free.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Ones(n + 1, n + 1);
  system.topLeftCorner(n, n) = hessian(free, free);
  system(n, n) = 0;
  VectorXd right(n + 1);
  right << gradient(free), 1;
  return system.partialPivLu().solve(right);
}

}  // namespace

VectorXd simplexLeastSquares(const Eigen::MatrixXd& hessian, const VectorXd& gradient) {
  // Variable K is what is left to 1, at no cost: the inequality becomes an equality. All is scaled by the
  // Hessian's size, which the sum's row of ones does not know.
  const Index count = gradient.size();
  const double scale = hessian.diagonal().maxCoeff();
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(count + 1, count + 1);
  h.topLeftCorner(count, count) = hessian / scale;
  VectorXd g = VectorXd::Zero(count + 1);
  g.head(count) = gradient / scale;
  VectorXd x = VectorXd::Unit(count + 1, count);
  std::vector<int> free{static_cast<int>(count)};
  double multiplier = 0;
  const double tolerance = 1e-12 * (1 + g.cwiseAbs().maxCoeff());
  for (Index turn = 0; turn < 10 * (count + 1); ++turn) {  // far more than it takes; rounding could cycle
    VectorXd gain = g - h * x;
    gain.array() -= multiplier;
    for (const int k : free) gain[k] = 0;
    Index best = 0;
    if (gain.maxCoeff(&best) <= tolerance) break;
    free.push_back(static_cast<int>(best));
    for (;;) {
      const VectorXd wanted = solveFree(h, g, free);
      double step = 1;
      std::size_t blocking = free.size();
      for (std::size_t k = 0; k < free.size(); ++k) {
        const double from = x[free[k]], to = wanted[static_cast<Index>(k)];
        if (to >= 0 || from - to <= 0) continue;
        if (const double share = from / (from - to); share < step) {
          step = share;
          blocking = k;
        }
      }
      for (std::size_t k = 0; k < free.size(); ++k)
        x[free[k]] += step * (wanted[static_cast<Index>(k)] - x[free[k]]);
      if (blocking == free.size()) {
        multiplier = wanted[static_cast<Index>(free.size())];
        break;
      }
      x[free[blocking]] = 0;
      free.erase(free.begin() + static_cast<std::ptrdiff_t>(blocking));
    }
  }
  return x.head(count);
}

}  // namespace falciform
