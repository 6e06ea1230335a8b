#include "Logic/Patches/GrooveCandidates.h"

#include <algorithm>
#include <cmath>

#include "Logic/Geometry/KdTree.h"
#include "Logic/Patches/GrooveFit.h"

namespace falciform {

namespace {

constexpr double kAlike = 0.8;     ///< a second line of so much of the first's probability looks alike
constexpr double kApartMm = 25;    ///< two grooves' lines are at least so far apart
constexpr double kNothing = 0.05;  ///< a probability below this is no candidate
constexpr double kSure = 0.5;      ///< from this probability of the first on no valley is asked for
constexpr double kRival = 0.5;     ///< a line of so much of the first's probability may go before it
constexpr double kAlongMm = 8;     ///< a place so near a valley lies along it
constexpr double kAlong = 0.5;     ///< a line with so much of its places along valleys runs along one
constexpr double kNever = -12;     ///< log-odds

/// Nothing more is looked for beside the line, nor above or below it: that would be the same groove again.
void lookElsewhere(const FeatureGround& ground, const Points& line, VectorXd& odds) {
  const KdTree near(line);
  const Eigen::RowVector3d right = ground.axes.rows.row(0);
  for (Index i = 0; i < odds.size(); ++i) {
    const Eigen::RowVector3d p = ground.surface.points.row(i);
    const Eigen::RowVector3d aside = p - line.row(near.nearest(p.transpose()).index);
    if (std::abs(aside.dot(right)) < kApartMm) odds[i] = kNever;
  }
}

/// Where what people mark does not decide, the rival that runs along a valley goes first.
void askTheValleys(const Points& valleys, std::vector<TracedLine>& lines) {
  if (valleys.rows() == 0) return;
  const KdTree tree(valleys);
  const auto alongValley = [&](const TracedLine& line) {
    double near = 0;
    for (Index i = 0; i < line.points.rows(); ++i)
      near += tree.nearest(line.points.row(i)).squaredDistance < kAlongMm * kAlongMm ? 1 : 0;
    return near >= kAlong * static_cast<double>(line.points.rows());
  };
  const double least = kRival * meanProbability(lines.front());
  const auto along = std::find_if(lines.begin(), lines.end(), [&](const TracedLine& line) {
    return meanProbability(line) >= least && alongValley(line);
  });
  if (along != lines.end()) std::rotate(lines.begin(), along, along + 1);
}

}  // namespace

double meanProbability(const TracedLine& line) {
  if (line.logOdds.size() == 0) return 0;
  return (1 / (1 + (-line.logOdds.array()).exp())).mean();
}

GrooveCandidates grooveCandidates(const FeatureGround& ground, const VectorXd& logOdds, int most) {
  GrooveCandidates all;
  VectorXd odds = logOdds;
  for (int c = 0; c < most; ++c) {
    TracedLine line = fitGroove(ground, odds);
    if (line.points.rows() < kShortestLineMm || meanProbability(line) < kNothing) break;
    lookElsewhere(ground, line.points, odds);
    if (!climbs(ground, line.points)) continue;  // across the liver: no groove does that
    all.lines.push_back(std::move(line));
  }
  std::stable_sort(all.lines.begin(), all.lines.end(), [](const TracedLine& a, const TracedLine& b) {
    return meanProbability(a) > meanProbability(b);
  });
  all.alike = all.lines.size() > 1 && meanProbability(all.lines[1]) > kAlike * meanProbability(all.lines[0]);
  if (!all.lines.empty() && meanProbability(all.lines.front()) < kSure)
    askTheValleys(valleysInFront(ground), all.lines);
  return all;
}

}  // namespace falciform
