#pragma once
#include <vector>

#include "Logic/Patches/FeatureEnds.h"
#include "Logic/Patches/FeatureGround.h"
#include "Logic/Patches/FeatureTracing.h"
#include "Logic/Patches/QuadraticScorer.h"

namespace falciform {

/// What is known of one feature: how its places look, and where it begins and ends.
struct LineModel {
  QuadraticScorer scorer;
  EndsModel ends;
};

/// What livers that people have marked tell of the inferior ridge and of the falciform groove.
struct FeatureModel {
  LineModel ridge, groove;
};

/// The model that comes with the program, from the 19 marked livers of Docs/Features.md.
[[nodiscard]] const FeatureModel& builtInFeatureModel();

/// A marked liver. Points of the marks lie about 1 mm apart, in the surface's frame.
struct MarkedLiver {
  FeatureGround ground;
  Points ridge, groove;
  double weight = 1;  ///< less than 1 for a patient who is there more than once
};

/// Fits both lines' models; the groove's sees the ridge's lines, as it will when it is used. At least two
/// livers with both marks, else InputError.
[[nodiscard]] FeatureModel trainFeatureModel(const std::vector<const MarkedLiver*>& livers,
                                             const Progress& progress = {});

/// The whole margin from right to left, longer than what people mark.
[[nodiscard]] TracedLine traceMargin(const FeatureGround& ground, const FeatureModel& model);
/// The part of the margin that people would mark.
[[nodiscard]] LineEnds ridgeEnds(const FeatureGround& ground, const TracedLine& margin,
                                 const FeatureModel& model);

/// Descriptors of each vertex for the groove: those of the ground and 7 of the way to the margin.
[[nodiscard]] Eigen::MatrixXd grooveDescriptors(const FeatureGround& ground, const TracedLine& margin);
/// The groove from its foot to its top, before its ends are chosen; `logOdds` of the groove's scorer.
[[nodiscard]] TracedLine traceGroove(const FeatureGround& ground, const VectorXd& logOdds);
/// What tells of a place of the groove as its end: its distance to the margin over the liver's size. A row a
/// point.
[[nodiscard]] Eigen::MatrixXd groovePlaces(const FeatureGround& ground, const TracedLine& line,
                                           const TracedLine& margin);
[[nodiscard]] LineEnds grooveEnds(const FeatureGround& ground, const TracedLine& line,
                                  const TracedLine& margin, const FeatureModel& model);

/// In [0, 1] a vertex: how much it is the top of a ridge (or the bottom of a valley), both sharp and
/// outermost.
[[nodiscard]] VectorXd crestOfGround(const FeatureGround& ground, bool valley);

}  // namespace falciform
