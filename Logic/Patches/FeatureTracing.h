#pragma once
#include "Logic/Patches/FeatureGround.h"

namespace falciform {

/// How a line is drawn where places that look like a feature lie in a row. Numbers without a unit are of
/// log-odds.
struct TracingPlan {
  /// Of a mm of path anywhere, beside minus the logarithm of its probability: small, so that the way round a
  /// notch is not cut short.
  double costFloor = 0.02;
  double costShift = 0;       ///< added to the log-odds for that
  double costOffCrest = 0.3;  ///< of a mm, times 1 - crest
  double gainShift = 3, leastGain = -1,
         mostGain = 1.5;   ///< of a mm: log-odds + shift, clamped: ends the line
  double smoothingMm = 2;  ///< standard deviation
};

/// A line over the surface.
struct TracedLine {
  Points points;     ///< N x 3, mm, 1 mm apart; smoothed, so up to a mm off the surface
  Points standard;   ///< N x 3, as FeatureGround::standard
  VectorXd logOdds;  ///< N, of the nearest vertex
};

/// The line of the greatest gain through the most likely vertex: cheapest paths from end to end, the ends
/// where gains summed along the path are greatest (three sweeps). `crest` in [0, 1] a vertex. The line runs
/// from the end that is farther along `axis` (0 right, 1 front, 2 head; reversed: farther back along it).
[[nodiscard]] TracedLine traceLine(const FeatureGround& ground, const VectorXd& logOdds,
                                   const VectorXd& crest, const TracingPlan& plan, int axis, bool reversed);

/// Points `first` to `last` of the line.
[[nodiscard]] TracedLine partOf(const TracedLine& line, Index first, Index last);

/// Points 1 mm apart along a polyline after smoothing with a Gaussian of `sigmaMm`; the ends stay.
[[nodiscard]] Points smoothedLine(const Points& polyline, double sigmaMm);

}  // namespace falciform
