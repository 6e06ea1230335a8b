#pragma once
#include <vector>

#include "Logic/Patches/FeatureEnds.h"
#include "Logic/Patches/FeatureGround.h"
#include "Logic/Patches/FeatureTracing.h"
#include "Logic/Patches/QuadraticScorer.h"

namespace falciform {

/// What livers that people have marked tell of the inferior ridge and of the falciform groove: how their
/// places look, and where the ridge begins and ends.
struct FeatureModel {
  QuadraticScorer ridge;
  EndsModel ridgeEnds;
  QuadraticScorer groove;
};

/// The model that comes with the program, from the 19 marked livers of Docs/Features.md.
[[nodiscard]] const FeatureModel& builtInFeatureModel();

/// A marked liver. Points of the marks lie about 1 mm apart, in the surface's frame.
struct MarkedLiver {
  FeatureGround ground;
  Points ridge, groove;
  double weight = 1;  ///< less than 1 for a patient who is there more than once
};

/// Fits the model; the groove's part sees the ridge's lines, as it will when it is used. At least two
/// livers with both marks, else InputError.
[[nodiscard]] FeatureModel trainFeatureModel(const std::vector<const MarkedLiver*>& livers,
                                             const Progress& progress = {});

/// The whole margin from right to left, longer than what people mark.
[[nodiscard]] TracedLine traceMargin(const FeatureGround& ground, const FeatureModel& model);
/// What tells where people begin and end on the margin, a row a point: how far right it lies, in standard
/// deviations, and how steeply the line climbs there (sine of the angle, from the patient's right to left).
[[nodiscard]] Eigen::MatrixXd endPlaces(const FeatureGround& ground, const TracedLine& margin);
/// The same cut short where it would go into notches: the way to this line tells best where the groove is.
[[nodiscard]] TracedLine traceSmoothMargin(const FeatureGround& ground, const FeatureModel& model);
/// The part of the margin that people would mark.
[[nodiscard]] LineEnds ridgeEnds(const FeatureGround& ground, const TracedLine& margin,
                                 const FeatureModel& model);

/// Descriptors of each vertex for the groove: those of the ground and 7 of the way to the smooth margin.
[[nodiscard]] Eigen::MatrixXd grooveDescriptors(const FeatureGround& ground, const TracedLine& margin);
/// In [0, 1] a vertex: how much it is the top of a ridge (or the bottom of a valley), both sharp and
/// outermost.
[[nodiscard]] VectorXd crestOfGround(const FeatureGround& ground, bool valley);

}  // namespace falciform
