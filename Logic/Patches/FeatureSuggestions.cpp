#include "Logic/Patches/FeatureSuggestions.h"

#include <algorithm>
#include <cmath>

#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/Patches/FeatureModel.h"
#include "Logic/Patches/GrooveFit.h"

namespace falciform {

namespace {

constexpr double kUnsure = 0.35;   ///< a score below this comes with a warning
constexpr double kAlike = 0.8;     ///< a second line of so much of the first's score comes with one too
constexpr double kApartMm = 25;    ///< two grooves' lines are at least so far apart
constexpr double kNothing = 0.05;  ///< a score below this is no candidate
constexpr double kAlongMm = 15;    ///< a candidate so near a valley follows it
constexpr double kNever = -12;     ///< log-odds
constexpr Index kShortestMm = 20;  ///< a shorter line is none

double meanProbability(const VectorXd& logOdds) {
  if (logOdds.size() == 0) return 0;
  return (1 / (1 + (-logOdds.array()).exp())).mean();
}

FeatureSuggestion suggestion(const Surface& surface, const TracedLine& line, int label, std::string what,
                             double widthMm) {
  FeatureSuggestion s;
  s.label = label;
  s.line = line.points;
  s.vertices = verticesAlong(surface, line.points, widthMm / 2);
  s.score = meanProbability(line.logOdds);
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

void suggestRidge(const Surface& surface, const FeatureGround& ground, const TracedLine& margin,
                  const SuggestionSettings& settings, FeatureSuggestions& all) {
  if (margin.points.rows() < kShortestMm) {
    all.warnings.emplace_back("no sharp lower margin was found; is this a liver, and are its axes right?");
    return;
  }
  const LineEnds ends = ridgeEnds(ground, margin, builtInFeatureModel());
  all.ridge.push_back(suggestion(surface, partOf(margin, ends.first, ends.last), patch::kInferiorRidge,
                                 "inferior ridge", settings.widthMm));
  if (settings.candidates > 1 && ends.last - ends.first + 1 < margin.points.rows())
    all.ridge.push_back(
        suggestion(surface, margin, patch::kInferiorRidge, "whole lower margin", settings.widthMm));
  if (all.ridge.front().score < kUnsure)
    all.warnings.emplace_back("the inferior ridge is unsure; look at it before you use it");
}

/// Where what people mark does not decide, the candidate along the strongest valley goes first; or the valley
/// itself.
void askTheValley(const Surface& surface, const TracedLine& valley, const SuggestionSettings& settings,
                  std::vector<FeatureSuggestion>& grooves) {
  if (valley.points.rows() < kShortestMm) return;
  const KdTree tree(valley.points);
  const auto meanAway = [&](const FeatureSuggestion& s) {
    double sum = 0;
    for (Index i = 0; i < s.line.rows(); ++i) sum += std::sqrt(tree.nearest(s.line.row(i)).squaredDistance);
    return sum / static_cast<double>(s.line.rows());
  };
  const auto along = std::min_element(grooves.begin(), grooves.end(), [&](const auto& a, const auto& b) {
    return meanAway(a) < meanAway(b);
  });
  if (along != grooves.end() && meanAway(*along) < kAlongMm) {
    std::rotate(grooves.begin(), along, along + 1);
  } else {
    grooves.insert(grooves.begin(),
                   suggestion(surface, valley, patch::kFalciform,
                              "falciform groove, as a valley of the front", settings.widthMm));
    if (grooves.size() > static_cast<std::size_t>(settings.candidates)) grooves.pop_back();
  }
}

void suggestGroove(const Surface& surface, const FeatureGround& ground, const TracedLine& margin,
                   const SuggestionSettings& settings, FeatureSuggestions& all) {
  const FeatureModel& model = builtInFeatureModel();
  VectorXd odds = model.groove.logOdds(grooveDescriptors(ground, margin));
  const VectorXd asLearnt = odds;
  for (int c = 0; c < settings.candidates; ++c) {
    const TracedLine line = fitGroove(ground, odds);
    if (line.points.rows() < kShortestMm || meanProbability(line.logOdds) < kNothing) break;
    lookElsewhere(ground, line.points, odds);
    if (!climbs(ground, line.points)) continue;  // across the liver: no groove does that
    all.groove.push_back(suggestion(
        surface, line, patch::kFalciform,
        all.groove.empty() ? "falciform groove" : otherGroove(ground, all.groove.front().line, line.points),
        settings.widthMm));
  }
  std::stable_sort(all.groove.begin(), all.groove.end(),
                   [](const FeatureSuggestion& a, const FeatureSuggestion& b) { return a.score > b.score; });
  const bool alike = all.groove.size() > 1 && all.groove[1].score > kAlike * all.groove[0].score;
  if (alike || all.groove.empty() || all.groove.front().score < kUnsure)
    askTheValley(surface, valleyGroove(ground, asLearnt), settings, all.groove);
  if (all.groove.empty())
    all.warnings.emplace_back("no falciform groove was found; paint it by hand");
  else if (all.groove.front().score < kUnsure)
    all.warnings.emplace_back("the falciform groove is unsure; look at it before you use it");
  if (alike)
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
  suggestGroove(surface, ground, margin, settings, all);
  progress.report(1, "Groove");
  return all;
}

}  // namespace falciform
