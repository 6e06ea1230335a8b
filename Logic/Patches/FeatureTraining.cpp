#include <algorithm>
#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Patches/FeatureModel.h"

namespace falciform {

namespace {

/// Vertices near a mark are examples, those well away from it counter-examples, those between neither.
struct Rule {
  double nearMm = 4, farMm = 9;
  int everyNth = 7;  ///< of the counter-examples, which are many
  double penalty = 50;
  double onMarkMm = 6;  ///< a point of a line so near a mark lies on it
};
constexpr Rule kRidge{}, kGroove{6, 15, 7, 50, 0};

struct Examples {
  std::vector<Eigen::MatrixXd> numbers;
  std::vector<double> yes, weight;
};

void gather(const Eigen::MatrixXd& numbers, const FeatureGround& ground, const Points& mark, double weight,
            const Rule& rule, Examples& all) {
  const KdTree tree(mark);
  std::vector<Index> rows;
  for (Index i = 0; i < numbers.rows(); ++i) {
    const double away = std::sqrt(tree.nearest(ground.surface.points.row(i)).squaredDistance);
    const bool yes = away < rule.nearMm;
    if (!yes && (away <= rule.farMm || i % rule.everyNth != 0)) continue;
    rows.push_back(i);
    all.yes.push_back(yes ? 1 : 0);
    all.weight.push_back(yes ? weight : weight * rule.everyNth);
  }
  Eigen::MatrixXd chosen(static_cast<Index>(rows.size()), numbers.cols());
  for (std::size_t r = 0; r < rows.size(); ++r) chosen.row(static_cast<Index>(r)) = numbers.row(rows[r]);
  all.numbers.push_back(std::move(chosen));
}

QuadraticScorer fitScorer(const Examples& all, double penalty) {
  Index rows = 0;
  for (const Eigen::MatrixXd& part : all.numbers) rows += part.rows();
  Eigen::MatrixXd numbers(rows, all.numbers.front().cols());
  Index at = 0;
  for (const Eigen::MatrixXd& part : all.numbers) {
    numbers.middleRows(at, part.rows()) = part;
    at += part.rows();
  }
  return fitQuadraticScorer(numbers, Eigen::Map<const VectorXd>(all.yes.data(), rows),
                            Eigen::Map<const VectorXd>(all.weight.data(), rows), penalty);
}

/// First and last point of the line that lie on the mark; the whole line if none does.
LineEnds endsOnMark(const TracedLine& line, const Points& mark, double onMarkMm) {
  const KdTree tree(mark);
  LineEnds ends{-1, -1};
  for (Index i = 0; i < line.points.rows(); ++i) {
    if (tree.nearest(line.points.row(i)).squaredDistance > onMarkMm * onMarkMm) continue;
    if (ends.first < 0) ends.first = i;
    ends.last = i;
  }
  if (ends.first < 0) ends = {0, line.points.rows() - 1};
  return ends;
}

/// Collects the numbers of true ends.
struct EndExamples {
  std::vector<VectorXd> numbers;
  std::vector<double> weights;
  void add(const TracedLine& line, const Eigen::MatrixXd& places, double sizeMm, const LineEnds& ends,
           double weight) {
    numbers.push_back(endNumbers(line, places, sizeMm, ends));
    weights.push_back(weight);
  }
};

}  // namespace

FeatureModel trainFeatureModel(const std::vector<const MarkedLiver*>& livers, const Progress& progress) {
  for (const MarkedLiver* liver : livers)
    if (liver->ridge.rows() == 0 || liver->groove.rows() == 0)
      throw InputError("a liver without a mark of the ridge or of the groove cannot teach where they are");
  if (livers.size() < 2)
    throw InputError("there are " + std::to_string(livers.size()) + " marked livers; at least 2 are needed");
  FeatureModel model;
  Examples ridge, groove;
  progress.report(0, "Learning the ridge");
  for (const MarkedLiver* liver : livers)
    gather(liver->ground.descriptors, liver->ground, liver->ridge, std::sqrt(liver->weight), kRidge, ridge);
  model.ridge = fitScorer(ridge, kRidge.penalty);
  progress.report(0.4, "Learning the groove");
  EndExamples ridgeExamples;
  for (const MarkedLiver* liver : livers) {
    const FeatureGround& ground = liver->ground;
    const TracedLine margin = traceMargin(ground, model);
    ridgeExamples.add(margin, endPlaces(ground, margin), ground.sizeMm,
                      endsOnMark(margin, liver->ridge, kRidge.onMarkMm), liver->weight);
    gather(grooveDescriptors(ground, traceSmoothMargin(ground, model)), ground, liver->groove,
           std::sqrt(liver->weight), kGroove, groove);
  }
  model.ridgeEnds = fitEnds(ridgeExamples.numbers, ridgeExamples.weights);
  model.ridgeEnds.shortestMm = 60;
  model.groove = fitScorer(groove, kGroove.penalty);
  progress.report(1, "Learning the groove");
  return model;
}

}  // namespace falciform
