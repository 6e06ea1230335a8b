#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Settings.h"
#include "Logic/Core/Surface.h"
#include "Logic/Patches/CrestStrength.h"
#include "Logic/Patches/FeatureGround.h"

namespace falciform {

/// How suggestions become patches.
struct SuggestionSettings {
  double widthMm = 12;  ///< of a patch, across its line
  int candidates = 3;   ///< at most so many lines a feature, the best first
};

template <class Visitor>
void describe(SuggestionSettings& s, Visitor&& field) {
  field(FieldInfo{"widthMm", "Patch width", "mm", 1, 60, "Width of a suggested patch, across its line."},
        s.widthMm);
  field(
      FieldInfo{"candidates", "Candidates", "", 1, 5, "At most so many lines of each feature are suggested."},
      s.candidates);
}

/// A line that may be a feature, and the patch around it.
struct FeatureSuggestion {
  int label = patch::kNone;   ///< patch::kInferiorRidge or patch::kFalciform
  Points line;                ///< N x 3, mm, 1 mm apart, within about 1 mm of the surface: the ridge from the
                              ///< patient's right to left, the groove from its foot to its top
  std::vector<int> vertices;  ///< of the surface, ascending: within half the width of the line
  double score = 0;           ///< in [0, 1]: mean probability of the places of its line
  double lengthMm = 0;
  std::string what;  ///< "inferior ridge", "whole lower margin", "second groove 41 mm to the left", ...
};

struct FeatureSuggestions {
  std::vector<FeatureSuggestion> ridge, groove;  ///< best first; empty if there is none
  std::vector<std::string> warnings;             ///< plain words: unsure, no groove, several alike
};

/// Suggests the inferior ridge and the falciform groove of a pre-operative liver: what 19 marked livers have
/// in common, found along the crest lines of this one (Docs/Features.md tells how well). `axes` say where the
/// patient's right, front and head are; a surface in LPS needs none. Any thread may call it; some seconds for
/// 60,000 vertices. Throws InputError for a cloud, a flat surface, or less than 200 vertices.
[[nodiscard]] FeatureSuggestions suggestFeatures(const Surface& surface,
                                                 const SuggestionSettings& settings = {},
                                                 const AnatomicalAxes& axes = lpsAxes(),
                                                 const Progress& progress = {});

/// The labels of `surface` (its own, or none) with the suggestion's vertices given the suggestion's label.
[[nodiscard]] std::vector<int> paintedLabels(const Surface& surface, const FeatureSuggestion& suggestion);

/// Vertices within `halfWidthMm` of a line, ascending: on the surface joined to the line by such vertices, so
/// that a fold beyond a gap is left out. For a polyline tool too.
[[nodiscard]] std::vector<int> verticesAlong(const Surface& surface, const Points& line, double halfWidthMm);

}  // namespace falciform
