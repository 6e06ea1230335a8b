// Success and warnings against what goes wrong: wrong labels, outliers, little to see, noise; and the hard
// synthetic beside Open3D. Prints the tables and writes the curves of Docs/Performance.md.
//   ./run bench robustness [--cases N] [--first SEED] [--svg FILE] [--details] [--hard-only]

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>

#include "Logic/Registration/SurfaceRegistration.h"
#include "Testing/Benchmarks/BentLivers.h"
#include "Testing/Benchmarks/CurveSvg.h"
#include "Testing/Benchmarks/Disturbances.h"
#include "Testing/Benchmarks/HardSynthetic.h"
#include "Testing/Benchmarks/Outcomes.h"

namespace falciform::bench {
namespace {

constexpr double kBendingMm = 3, kEdgeMm = 2.5, kRightMm = 5, kUsualNoiseMm = 0.5, kUsualShare = 0.3;

/// A liver and its usual scan, from which the sweeps start.
struct Usual {
  const BentLiver& liver;
  std::vector<Station> stations;
  BenchCase seen;
  std::uint64_t seed;
};

/// One thing that goes wrong, and how a case looks under it.
struct Sweep {
  std::string title, axis;
  std::vector<double> values;  ///< in the axis's unit
  std::function<BenchCase(const Usual&, double value)> make;
};

std::vector<Sweep> sweeps() {
  return {
      {"Wrong labels",
       "mislabelled patch points, %",
       {0, 10, 20, 30, 40},
       [](const Usual& usual, double percent) {
         BenchCase c = usual.seen;
         c.scan = withWrongLabels(c.scan, percent / 100, usual.seed);
         return c;
       }},
      {"Outliers",
       "scan points that are no liver, %",
       {0, 5, 10, 20, 30},
       [](const Usual& usual, double percent) {
         BenchCase c = usual.seen;
         c.scan = withOutliers(c.scan, percent / 100, usual.seed);
         return c;
       }},
      {"Coverage",
       "share of the surface that is seen, %",
       {10, 15, 20, 25, 30, 45},
       [](const Usual& usual, double percent) {
         return usual.liver.seen(usual.liver.aim(percent / 100), kUsualNoiseMm);
       }},
      {"Noise",
       "standard deviation along the ray, mm",
       {0, 0.5, 1, 2, 3},
       [](const Usual& usual, double mm) { return usual.liver.seen(usual.stations, mm); }},
  };
}

Outcome run(const BenchCase& c, const PreparedPreop& preop, const OurMethod& method, bool details) {
  const RegistrationResult result = registerSurfaces(preop, c.scan, method.settings);
  const double apart = apartFromBestMm(c, result.scanFromPreop);
  if (details)
    std::printf("# %s, %s: error %.2f (optimal %.2f), apart %.2f, expected %.2f, warnings %zu\n",
                c.name.c_str(), method.name.c_str(), targetErrorMm(c, result.scanFromPreop), c.optimalMm,
                apart, result.expectedErrorMeanMm, result.warnings.size());
  return {targetErrorMm(c, result.scanFromPreop),
          apart,
          apart < kRightMm,
          !result.warnings.empty(),
          1e3 * result.seconds,
          0};
}

void printSweep(const Sweep& sweep, const std::vector<OurMethod>& methods,
                const std::vector<std::vector<Tally>>& tallies, const std::vector<double>& coverage) {
  std::printf("## %s\n\n| %s |", sweep.title.c_str(), sweep.axis.c_str());
  for (const OurMethod& method : methods)
    std::printf(" %s: right | silent | right, yet warned |", method.name.c_str());
  std::printf(" seen |\n|---|");
  for (std::size_t m = 0; m < methods.size(); ++m) std::printf("---|---|---|");
  std::puts("---|");
  for (std::size_t v = 0; v < sweep.values.size(); ++v) {
    std::printf("| %g |", sweep.values[v]);
    for (const Tally& t : tallies[v])
      std::printf(" %d of %d | %d | %d |", t.right, t.cases, t.silent, t.falseAlarms);
    std::printf(" %.0f %% |\n", 100 * coverage[v]);
  }
  std::puts("");
  std::fflush(stdout);
}

std::vector<CurvePanel> runSweeps(int first, int cases, bool details) {
  const std::vector<OurMethod> methods = ourMethods();
  const std::vector<Sweep> all = sweeps();
  // [sweep][value][method]
  std::vector<std::vector<std::vector<Tally>>> tallies;
  std::vector<std::vector<double>> coverage;
  for (const Sweep& sweep : all) {
    tallies.emplace_back(sweep.values.size(), std::vector<Tally>(methods.size()));
    coverage.emplace_back(sweep.values.size(), 0.0);
  }
  for (int seed = first; seed < first + cases; ++seed) {
    const BentLiver liver(seed, kBendingMm, kEdgeMm);
    const PreparedPreop preop(liver.preop());
    Usual usual{liver, liver.aim(kUsualShare), {}, static_cast<std::uint64_t>(seed)};
    usual.seen = liver.seen(usual.stations, kUsualNoiseMm);
    for (std::size_t s = 0; s < all.size(); ++s)
      for (std::size_t v = 0; v < all[s].values.size(); ++v) {
        const BenchCase c = all[s].make(usual, all[s].values[v]);
        coverage[s][v] += c.coverage / cases;
        if (details) std::printf("# %s %g\n", all[s].axis.c_str(), all[s].values[v]);
        for (std::size_t m = 0; m < methods.size(); ++m)
          tallies[s][v][m].add(run(c, preop, methods[m], details));
      }
  }
  std::vector<CurvePanel> panels;
  for (std::size_t s = 0; s < all.size(); ++s) {
    printSweep(all[s], methods, tallies[s], coverage[s]);
    CurvePanel panel{all[s].title, all[s].axis, {}};
    for (std::size_t m = 0; m < methods.size(); ++m) {
      Curve curve{methods[m].name, all[s].values, {}, {}};
      for (const auto& row : tallies[s]) {
        curve.solid.push_back(row[m].rightShare());
        curve.dashed.push_back(row[m].saidShare());
      }
      panel.curves.push_back(std::move(curve));
    }
    panels.push_back(std::move(panel));
  }
  return panels;
}

}  // namespace
}  // namespace falciform::bench

int main(int argc, char** argv) {
  using namespace falciform::bench;
  int cases = 25, first = 1;
  const char* svg = nullptr;
  bool details = false, hardOnly = false;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--cases") == 0 && i + 1 < argc)
      cases = std::atoi(argv[++i]);
    else if (std::strcmp(argv[i], "--first") == 0 && i + 1 < argc)
      first = std::atoi(argv[++i]);
    else if (std::strcmp(argv[i], "--svg") == 0 && i + 1 < argc)
      svg = argv[++i];
    else if (std::strcmp(argv[i], "--details") == 0)
      details = true;
    else if (std::strcmp(argv[i], "--hard-only") == 0)
      hardOnly = true;
    else
      cases = 0;
  }
  if (cases < 1 || first < 1) {
    std::fputs(
        "bench-robustness [--cases N] [--first SEED] [--svg FILE] [--details] [--hard-only]; N and SEED are "
        "at least 1\n",
        stderr);
    return 2;
  }
  printHardSynthetic(first, cases, details);
  if (hardOnly) return 0;
  std::printf(
      "Below: %d livers, %.0f mm RMS bending, 0.5 mm noise, 30 %% visible where nothing else is said. Right: "
      "targets within "
      "%.0f mm of where the best rigid motion puts them, on average. Silent: wrong and no warning.\n\n",
      cases, kBendingMm, kRightMm);
  const std::vector<CurvePanel> panels = runSweeps(first, cases, details);
  if (svg) std::ofstream(svg) << curvesSvg(panels, "right", "right, or wrong with a warning");
}
