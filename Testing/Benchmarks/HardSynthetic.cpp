#include "Testing/Benchmarks/HardSynthetic.h"

#include <cstdio>
#include <string>

#include "Logic/Registration/SurfaceRegistration.h"
#include "Testing/Benchmarks/BentLivers.h"
#include "Testing/Benchmarks/Outcomes.h"
#include "Testing/Benchmarks/Stopwatch.h"
#ifdef FALCIFORM_BENCH_OPEN3D
#include "Testing/Benchmarks/Open3dPeer.h"
#endif

namespace falciform::bench {

namespace {

constexpr double kBendingMm = 5.5, kNoiseMm = 1, kVisible = 0.21, kEdgeMm = 2;

Outcome outcomeOf(const BenchCase& c, const Isometry3d& scanFromPreop, const Spent& spent) {
  Outcome o;
  o.errorMm = targetErrorMm(c, scanFromPreop);
  o.apartMm = apartFromBestMm(c, scanFromPreop);
  o.right = o.errorMm <= c.limitMm;
  o.wallMs = spent.wallMs;
  o.cpuMs = spent.cpuMs;
  return o;
}

void printDetails(const BenchCase& c, const std::string& method, const Outcome& o,
                  const RegistrationResult& r) {
  std::printf(
      "# %s, %s: %s, error %.2f (optimal %.2f), apart %.2f, scores %.4f %.4f, coverage %.3f, rms %.2f, "
      "expected %.2f, patches",
      c.name.c_str(), method.c_str(), o.right ? "right" : "FAILED", o.errorMm, c.optimalMm, o.apartMm,
      r.basins[0].score, r.basins.size() > 1 ? r.basins[1].score : -1.0, r.coverage, r.rmsMm,
      r.expectedErrorMeanMm);
  for (const auto& [label, mm] : r.patchRmsMm) std::printf(" %d: %.2f", label, mm);
  std::printf("\n");
  for (const std::string& warning : r.warnings) std::printf("#   %s\n", warning.c_str());
}

void printRow(const std::string& name, const Tally& t, bool warns) {
  std::printf("| %s | %d of %d | %d | ", name.c_str(), t.right, t.cases, t.within5);
  if (warns)
    std::printf("%d of %d | %d of %d", t.cases - t.right - t.silent, t.cases - t.right, t.falseAlarms,
                t.right);
  else
    std::printf("never | never");
  std::printf(" | %.1f | %.1f | %.0f |\n", quantile(t.errorsMm, 0.5), quantile(t.errorsMm, 1),
              quantile(t.wallMs, 0.5));
}

}  // namespace

void printHardSynthetic(int first, int cases, bool details) {
  const std::vector<OurMethod> methods = ourMethods();
  std::vector<Tally> ours(methods.size());
  [[maybe_unused]] Tally ransac, fgr;
  std::vector<double> optimal, coverage;
  for (int seed = first; seed < first + cases; ++seed) {
    const BenchCase c = [&] {
      const BentLiver liver(seed, kBendingMm, kEdgeMm);
      return liver.seen(liver.aim(kVisible), kNoiseMm, 2);
    }();
    optimal.push_back(c.optimalMm);
    coverage.push_back(c.coverage);
    const PreparedPreop preop(c.preop);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      RegistrationResult result;
      const Spent spent = measured([&] { result = registerSurfaces(preop, c.scan, methods[m].settings); });
      Outcome o = outcomeOf(c, result.scanFromPreop, spent);
      o.warned = !result.warnings.empty();
      ours[m].add(o);
      if (details) printDetails(c, methods[m].name, o, result);
    }
#ifdef FALCIFORM_BENCH_OPEN3D
    const Open3dTarget target(c.preop);
    for (Tally* tally : {&ransac, &fgr}) {
      Isometry3d preopFromScan;
      const Spent spent = measured(
          [&] { preopFromScan = tally == &ransac ? target.ransac(c.scan, seed) : target.fgr(c.scan); });
      tally->add(outcomeOf(c, preopFromScan.inverse(), spent));
    }
#endif
  }
  std::printf("## The hard synthetic: %.0f-%.0f %% visible, %.1f mm RMS bending, %.0f mm noise\n\n",
              100 * quantile(coverage, 0), 100 * quantile(coverage, 1), kBendingMm, kNoiseMm);
  std::printf(
      "Right: mean target error at most 1.4 x that of the best rigid motion (median %.1f mm) + 1 mm.\n\n",
      quantile(optimal, 0.5));
  std::puts(
      "| method | right | within 5 mm of the best rigid pose | failures warned of | right, yet warned | "
      "target error, median, mm | largest | wall, median, ms |\n|---|---|---|---|---|---|---|---|");
  for (std::size_t m = 0; m < methods.size(); ++m) printRow(methods[m].name, ours[m], true);
#ifdef FALCIFORM_BENCH_OPEN3D
  printRow("Open3D FPFH + RANSAC + ICP", ransac, false);
  printRow("Open3D FPFH + FGR + ICP", fgr, false);
#endif
  std::puts("");
  std::fflush(stdout);
}

}  // namespace falciform::bench
