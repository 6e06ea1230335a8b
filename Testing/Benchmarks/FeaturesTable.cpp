// bench-features: the two features on the livers of surfaces/, each by a model that has not seen its patient.
#include <cstdio>

#include "Testing/Benchmarks/MarkedLivers.h"
#include "Testing/Support/RealData.h"

namespace falciform {
namespace {}
}  // namespace falciform

int main() {
  using namespace falciform;
  const std::vector<bench::AnnotatedLiver> livers = bench::readAnnotatedLivers(test::realData() / "surfaces");
  std::map<std::string, FeatureModel> models;
  for (const auto& liver : livers) {
    if (models.count(liver.patient)) continue;
    std::vector<const MarkedLiver*> others;
    for (const auto& other : livers)
      if (other.patient != liver.patient) others.push_back(&other.marked);
    models[liver.patient] = trainFeatureModel(others);
    std::fprintf(stderr, "%s\n", liver.patient.c_str());
  }
  for (const auto& liver : livers) {
    const FeatureModel& model = models[liver.patient];
    const FeatureGround& ground = liver.marked.ground;
    const TracedLine margin = traceMargin(ground, model);
    const LineEnds ends = ridgeEnds(ground, margin, model);
    const TracedLine ridge = partOf(margin, ends.first, ends.last);
    const auto line = bench::agreement(ridge.points, liver.marked.ridge, 5);
    std::printf("%s | %.2f %.2f %.1f %.1f | %ld %ld-%ld", liver.name.c_str(), line.precision, line.recall,
                line.meanToTruthMm, line.meanFromTruthMm, (long)margin.points.rows(), (long)ends.first,
                (long)ends.last);
    const TracedLine whole =
        traceGroove(ground, model.groove.scorer.logOdds(grooveDescriptors(ground, margin)));
    const LineEnds g = grooveEnds(ground, whole, margin, model);
    const auto groove = bench::agreement(partOf(whole, g.first, g.last).points, liver.marked.groove, 10);
    std::printf(" | %.2f %.2f %.1f %.1f | %ld %ld-%ld\n", groove.precision, groove.recall,
                groove.meanToTruthMm, groove.meanFromTruthMm, (long)whole.points.rows(), (long)g.first,
                (long)g.last);
  }
}
