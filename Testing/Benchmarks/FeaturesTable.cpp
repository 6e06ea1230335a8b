// Prints the table of Docs/Features.md: the two features as suggested on the 19 marked livers, each by a
// model that has not seen its patient.   ./run bench features [FOLDER: the lines as CSV, for a look at them]

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>

#include "Logic/Patches/FeatureSuggestions.h"
#include "Logic/Patches/GrooveCandidates.h"
#include "Testing/Benchmarks/MarkedLivers.h"
#include "Testing/Support/RealData.h"

namespace falciform {
namespace {

constexpr double kRidgeMm = 5, kGrooveMm = 10;           // tolerances
constexpr double kRidgeShare = 0.8, kGrooveShare = 0.5;  // what is called right

/// Trained on all livers but those of one patient.
FeatureModel modelWithout(const std::vector<bench::AnnotatedLiver>& livers, const std::string& patient) {
  std::vector<const MarkedLiver*> others;
  for (const bench::AnnotatedLiver& liver : livers)
    if (liver.patient != patient) others.push_back(&liver.marked);
  return trainFeatureModel(others);
}

/// Edges between the vertices of the patch, as the marks are edges.
std::vector<Eigen::Vector2i> edgesWithin(const Surface& surface, const std::vector<int>& patch) {
  std::vector<Eigen::Vector2i> edges;
  const Adjacency neighbours = neighboursOfVertices(surface.triangles, surface.size());
  for (const int v : patch)
    for (const int* n = neighbours.begin(v); n != neighbours.end(v); ++n)
      if (*n > v && std::binary_search(patch.begin(), patch.end(), *n)) edges.emplace_back(v, *n);
  return edges;
}

struct Outcome {
  bench::Agreement ridgePatch, ridgeLine, groove;
  double ridgeScore = 0, grooveScore = 0;
};

void writeLine(const std::string& file, const TracedLine& line, const LineEnds& ends) {
  std::ofstream out(file);
  out << "x_mm,y_mm,z_mm,right,front,head,log_odds,chosen\n";
  for (Index i = 0; i < line.points.rows(); ++i)
    out << line.points(i, 0) << ',' << line.points(i, 1) << ',' << line.points(i, 2) << ','
        << line.standard(i, 0) << ',' << line.standard(i, 1) << ',' << line.standard(i, 2) << ','
        << line.logOdds[i] << ',' << (i >= ends.first && i <= ends.last) << '\n';
}

Outcome outcomeOf(const bench::AnnotatedLiver& liver, const FeatureModel& model, const std::string& folder) {
  const FeatureGround& ground = liver.marked.ground;
  Outcome outcome;
  const TracedLine margin = traceMargin(ground, model);
  const LineEnds ends = ridgeEnds(ground, margin, model);
  const Points ridge = partOf(margin, ends.first, ends.last).points;
  outcome.ridgeLine = bench::agreement(ridge, liver.marked.ridge, kRidgeMm);
  const std::vector<int> patch = verticesAlong(liver.surface, ridge, SuggestionSettings{}.widthMm / 2);
  outcome.ridgePatch =
      bench::agreement(bench::alongEdges(liver.surface.points, edgesWithin(liver.surface, patch)),
                       liver.marked.ridge, kRidgeMm);

  const GrooveCandidates grooves = grooveCandidates(
      ground, model.groove.logOdds(grooveDescriptors(ground, traceSmoothMargin(ground, model))), 3);
  const TracedLine groove = grooves.lines.empty() ? TracedLine{} : grooves.lines.front();
  outcome.groove = bench::agreement(groove.points, liver.marked.groove, kGrooveMm);
  if (!folder.empty()) {
    writeLine(folder + "/" + liver.name + "_margin.csv", margin, ends);
    writeLine(folder + "/" + liver.name + "_groove.csv", groove, {0, groove.points.rows() - 1});
  }
  return outcome;
}

bool right(const bench::Agreement& a, double share) { return std::min(a.precision, a.recall) >= share; }

void print(const bench::AnnotatedLiver& liver, const Outcome& o) {
  std::printf("| %s | %s | %.2f | %.2f | %s | %.1f | %.1f | %.2f | %.2f | %s | %.1f | %.1f |\n",
              liver.name.c_str(), liver.patient.c_str(), o.ridgePatch.precision, o.ridgePatch.recall,
              right(o.ridgePatch, kRidgeShare) ? "yes" : "no", o.ridgeLine.meanToTruthMm,
              o.ridgeLine.meanFromTruthMm, o.groove.precision, o.groove.recall,
              right(o.groove, kGrooveShare) ? "yes" : "no", o.groove.meanToTruthMm, o.groove.meanFromTruthMm);
  std::fflush(stdout);
}

}  // namespace
}  // namespace falciform

int main(int count, char** words) {
  using namespace falciform;
  if (!std::filesystem::exists(test::realData() / "surfaces")) {
    std::puts("the real cases are not here; set FALCIFORM_DATA");
    return 2;
  }
  const std::vector<bench::AnnotatedLiver> livers = bench::readAnnotatedLivers(test::realData() / "surfaces");
  std::puts(
      "| liver | patient | ridge precision | ridge recall | right | to mark, mm | from mark, mm | groove "
      "precision | "
      "groove recall | right | to mark, mm | from mark, mm |");
  std::puts("|---|---|---|---|---|---|---|---|---|---|---|---|");
  std::map<std::string, FeatureModel> models;
  int ridges = 0, grooves = 0;
  for (const bench::AnnotatedLiver& liver : livers) {
    if (!models.contains(liver.patient)) models[liver.patient] = modelWithout(livers, liver.patient);
    const Outcome outcome = outcomeOf(liver, models[liver.patient], count > 1 ? words[1] : "");
    ridges += right(outcome.ridgePatch, kRidgeShare) ? 1 : 0;
    grooves += right(outcome.groove, kGrooveShare) ? 1 : 0;
    print(liver, outcome);
  }
  std::printf("\nRidge right on %d of %zu livers, groove on %d.\n", ridges, livers.size(), grooves);
}
