#pragma once
#include <vector>

#include "Logic/Patches/FeatureTracing.h"

namespace falciform {

/// Where along a line a feature begins and ends: first and last point of the line.
struct LineEnds {
  Index first = 0, last = 0;
};

/// Where people let a feature begin and end, as a normal distribution of numbers that do not depend on the
/// liver's size; and how much the look of the places between counts beside it.
struct EndsModel {
  VectorXd mean;
  Eigen::MatrixXd precision;  ///< inverse covariance
  double evidence = 0.1;      ///< log-odds are counted in so many units a 50 mm of line
  double shortestMm = 20;
};

/// The numbers of a pair of ends: those of `places` (a row a point of the line) at both, and how far apart
/// they are, as the crow flies, over the liver's size: what a line does at a notch on its way does not count.
[[nodiscard]] VectorXd endNumbers(const TracedLine& line, const Eigen::MatrixXd& places, double sizeMm,
                                  const LineEnds& ends);

/// Mean and covariance of rows of numbers, each counted by its weight; covariances are drawn to 0 by `share`,
/// since there are few livers.
[[nodiscard]] EndsModel fitEnds(const std::vector<VectorXd>& numbers, const std::vector<double>& weights,
                                double share = 0.1);

/// First and last point of the line that are more likely between the ends than beyond them, over all pairs of
/// ends. The whole line if it is too short to choose.
[[nodiscard]] LineEnds likelyEnds(const TracedLine& line, const Eigen::MatrixXd& places, double sizeMm,
                                  const EndsModel& model);

}  // namespace falciform
