#pragma once
#include <vector>

#include "Logic/Patches/FeatureTracing.h"

namespace falciform {

/// Lines that may be the falciform groove, best first, each from foot to top.
struct GrooveCandidates {
  std::vector<TracedLine> lines;
  bool alike = false;  ///< two places look alike
};

/// At most `most` lines through places that look like a groove by the log-odds of its scorer (a vertex),
/// at least 25 mm apart. Where none is likelier than not, one that runs along a valley of the front
/// (valleysInFront) goes before others up to twice as likely. Empty if nothing is likely.
[[nodiscard]] GrooveCandidates grooveCandidates(const FeatureGround& ground, const VectorXd& logOdds,
                                                int most);

/// Mean probability of the places of a line, in [0, 1]; 0 of no line.
[[nodiscard]] double meanProbability(const TracedLine& line);
inline constexpr double kUnsureProbability = 0.35;  ///< below it a line is unsure
inline constexpr Index kShortestLineMm = 20;        ///< a shorter line is none

}  // namespace falciform
