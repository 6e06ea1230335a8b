#include "Logic/Patches/FeatureSuggestions.h"

#include <algorithm>
#include <cmath>

#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/Patches/FeatureModel.h"
#include "Logic/Patches/GrooveCandidates.h"

namespace falciform {

namespace {

FeatureSuggestion suggestion(const Surface& surface, const TracedLine& line, int label, std::string what,
                             double widthMm) {
  FeatureSuggestion s;
  s.label = label;
  s.line = line.points;
  s.vertices = verticesAlong(surface, line.points, widthMm / 2);
  s.score = meanProbability(line);
  s.lengthMm = static_cast<double>(std::max<Index>(line.points.rows() - 1, 0));
  s.what = std::move(what);
  return s;
}

std::string otherGroove(const FeatureGround& ground, const Points& first, const Points& other) {
  const double right =
      ((other.colwise().mean() - first.colwise().mean()) * ground.axes.rows.row(0).transpose()).value();
  return "another groove, " + std::to_string(std::lround(std::abs(right))) + " mm to the patient's " +
         (right > 0 ? "right" : "left");
}

void suggestRidge(const Surface& surface, const FeatureGround& ground, const TracedLine& margin,
                  const SuggestionSettings& settings, FeatureSuggestions& all) {
  if (margin.points.rows() < kShortestLineMm) {
    all.warnings.emplace_back("no sharp lower margin was found; is this a liver, and are its axes right?");
    return;
  }
  const LineEnds ends = ridgeEnds(ground, margin, builtInFeatureModel());
  all.ridge.push_back(suggestion(surface, partOf(margin, ends.first, ends.last), patch::kInferiorRidge,
                                 "inferior ridge", settings.widthMm));
  if (settings.candidates > 1 && ends.last - ends.first + 1 < margin.points.rows())
    all.ridge.push_back(
        suggestion(surface, margin, patch::kInferiorRidge, "whole lower margin", settings.widthMm));
  if (all.ridge.front().score < kUnsureProbability)
    all.warnings.emplace_back("the inferior ridge is unsure; look at it before you use it");
}

void suggestGroove(const Surface& surface, const FeatureGround& ground, const TracedLine& margin,
                   const SuggestionSettings& settings, FeatureSuggestions& all) {
  const VectorXd odds = builtInFeatureModel().groove.logOdds(grooveDescriptors(ground, margin));
  const GrooveCandidates grooves = grooveCandidates(ground, odds, settings.candidates);
  for (const TracedLine& line : grooves.lines) {
    std::string what = "falciform groove";
    if (!all.groove.empty()) what = otherGroove(ground, all.groove.front().line, line.points);
    all.groove.push_back(suggestion(surface, line, patch::kFalciform, std::move(what), settings.widthMm));
  }
  if (all.groove.empty())
    all.warnings.emplace_back("no falciform groove was found; paint it by hand");
  else if (all.groove.front().score < kUnsureProbability)
    all.warnings.emplace_back("the falciform groove is unsure; look at it before you use it");
  if (grooves.alike)
    all.warnings.emplace_back("two places look alike for the falciform groove; look at both candidates");
}

}  // namespace

std::vector<int> verticesAlong(const Surface& surface, const Points& line, double halfWidthMm) {
  if (line.rows() == 0 || surface.size() == 0) return {};
  const KdTree onLine(line);
  std::vector<char> near(static_cast<std::size_t>(surface.size()), 0);
  std::vector<int> inside;
  for (Index i = 0; i < surface.size(); ++i)
    if (onLine.nearest(surface.points.row(i)).squaredDistance <= halfWidthMm * halfWidthMm) {
      near[static_cast<std::size_t>(i)] = 1;
      inside.push_back(static_cast<int>(i));
    }
  if (surface.triangles.rows() == 0 || inside.empty()) return inside;
  const Adjacency neighbours = neighboursOfVertices(surface.triangles, surface.size());
  const KdTree vertices(surface.points, inside);
  std::vector<int> front;
  const auto enter = [&](int v) {
    if (near[static_cast<std::size_t>(v)] != 1) return;
    near[static_cast<std::size_t>(v)] = 2;
    front.push_back(v);
  };
  for (Index p = 0; p < line.rows(); ++p) enter(vertices.nearest(line.row(p)).index);
  while (!front.empty()) {
    const int v = front.back();
    front.pop_back();
    for (const int* n = neighbours.begin(v); n != neighbours.end(v); ++n) enter(*n);
  }
  std::erase_if(inside, [&](int v) { return near[static_cast<std::size_t>(v)] != 2; });
  return inside;
}

std::vector<int> paintedLabels(const Surface& surface, const FeatureSuggestion& suggestion) {
  std::vector<int> labels = surface.patch;
  if (labels.empty()) labels.assign(static_cast<std::size_t>(surface.size()), patch::kNone);
  for (const int v : suggestion.vertices) labels[static_cast<std::size_t>(v)] = suggestion.label;
  return labels;
}

FeatureSuggestions suggestFeatures(const Surface& surface, const SuggestionSettings& settings,
                                   const AnatomicalAxes& axes, const Progress& progress) {
  checkSettings(settings);
  const FeatureGround ground = featureGround(surface, axes, progress.part(0, 0.7));
  progress.report(0.7, "Lower margin");
  const TracedLine margin = traceMargin(ground, builtInFeatureModel());
  FeatureSuggestions all;
  suggestRidge(surface, ground, margin, settings, all);
  progress.report(0.85, "Groove");
  suggestGroove(surface, ground, traceSmoothMargin(ground, builtInFeatureModel()), settings, all);
  progress.report(1, "Groove");
  return all;
}

}  // namespace falciform
