// How long a change of supports takes until the surface is there: bench-supports [SURFACE.vtp] [EDGE_MM]. The
// built-in liver without a surface. Medians of 20 changes.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <thread>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Biomechanics/SupportResponse.h"
#include "Logic/Biomechanics/SupportTemplates.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Benchmarks/Stopwatch.h"

using namespace falciform;

namespace {

struct Times {
  double medianMs = 0, worstMs = 0;
};

Times timed(const std::function<void(int)>& change) {
  constexpr int kChanges = 20;
  change(0);  // memory is touched for the first time
  std::vector<double> ms;
  for (int i = 1; i <= kChanges; ++i) {
    ms.push_back(bench::measured([&] { change(i); }).wallMs);
  }
  std::sort(ms.begin(), ms.end());
  return {ms[ms.size() / 2], ms.back()};
}

void line(const char* what, const Times& times) {
  std::printf("| %s | %.1f | %.1f |\n", what, times.medianMs, times.worstMs);
}

}  // namespace

int main(int argc, char** argv) {
  const Surface surface =
      argc > 1 ? readSurface(argv[1]).value : makeSyntheticLiver(SyntheticLiverSettings{}).surface;
  LiverModelSettings settings;
  if (argc > 2) settings.edgeLengthMm = std::atof(argv[2]);
  const auto preop = std::make_shared<const Surface>(surface);
  std::shared_ptr<const SupportModel> model;
  const bench::Spent preparing =
      bench::measured([&] { model = prepareSupportModel(preop, {}, nullptr, settings); });
  std::printf("%ld surface points, %ld nodes, %ld elements, %ld candidate directions; %u threads\n",
              static_cast<long>(preop->size()), static_cast<long>(model->liver.mesh.nodes()),
              static_cast<long>(model->liver.mesh.size()),
              static_cast<long>(model->solver.candidateDirections()), std::thread::hardware_concurrency());
  std::printf("prepared (meshing, sites, factorisation) in %.1f s\n\n", preparing.wallMs / 1000);

  const SupportTemplateSettings packed;
  const SupportPainting painting = paintedTemplate(*model, emptySupportPainting(preop->size()), packed);
  std::printf("| change, until the surface's points are there | median ms | worst ms |\n|---|---|---|\n");
  SupportHypothesis hypothesis;
  hypothesis.supports = supportsOf(*model, painting).supports;
  line("distance, as a solution of its own", timed([&](int i) {
         hypothesis.supports.back().pushMm = i;
         const Points field = model->solver.solve(hypothesis);
         const Points moved = preop->points + Points(model->places.interpolate(field));
         if (!moved.allFinite()) std::abort();
       }));
  const std::vector<Vector3d> places = packingSites(model->sites, 21);
  line("packing elsewhere, all else as well (paint to slider)", timed([&](int i) {
         std::vector<Support> supports = hypothesis.supports;
         supports.back().faces = packingSite(model->sites, places[static_cast<std::size_t>(i)], 30);
         const SupportResponse response(model, supports);
         if (!(response.at({0, 0, 20}, 0).largestMm > 0)) std::abort();
       }));
  const SupportResponse response(model, hypothesis.supports);
  line("slider: distance and turn, with min det J", timed([&](int i) {
         if (!(response.at({0, 0, 1.0 + i}, i).largestMm > 0)) std::abort();
       }));
  // What holds the liver known and eliminated beforehand, packing anywhere on the undersides: only that is a
  // hypothesis.
  CandidateSupports candidates;
  candidates.sliding = model->sites.leftUnderside;
  candidates.sliding.insert(candidates.sliding.end(), model->sites.rightUnderside.begin(),
                            model->sites.rightUnderside.end());
  candidates.held = lyingOnItsBack(model->sites);
  const SupportSolver solver(model->liver.mesh, {Material{}}, candidates);
  const auto packing = [&](int i) {
    return SupportHypothesis{
        .supports = {{.name = "pack",
                      .kind = SupportKind::Pushed,
                      .faces = packingSite(model->sites, places[static_cast<std::size_t>(i)], 30),
                      .pushMm = 20}}};
  };
  std::vector<SupportHypothesis> all;
  for (int i = 0; i <= 20; ++i) all.push_back(packing(i));
  std::printf(
      "\n| new hypothesis, supports held beforehand (%ld candidate directions): all nodes | median ms | "
      "worst ms |\n"
      "|---|---|---|\n",
      static_cast<long>(solver.candidateDirections()));
  line("packing elsewhere", timed([&](int i) {
         if (!solver.solve(all[static_cast<std::size_t>(i)]).allFinite()) std::abort();
       }));
  line("20 packings at once, each", [&] {
    Times times = timed([&](int) {
      if (solver.solve(std::vector<SupportHypothesis>(all.begin(), all.begin() + 20)).size() != 20)
        std::abort();
    });
    times.medianMs /= 20;
    times.worstMs /= 20;
    return times;
  }());
  return 0;
}
