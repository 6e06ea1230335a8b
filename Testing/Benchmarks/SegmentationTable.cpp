// ./run bench segmentation [DRAWS]: the level set on the two real CTs with a liver's mask
// (Docs/Segmentation.md): Dice, surface distances, time, the spread when every click is moved 5 mm in a
// random direction, and the first clicks without enclosed tissue.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "Logic/Core/Parallel.h"
#include "Logic/IO/VolumeFiles.h"
#include "Logic/Segmentation/GridFilters.h"
#include "Logic/Segmentation/LevelSet.h"
#include "Logic/Segmentation/RegionPieces.h"
#include "Testing/Benchmarks/MaskedCts.h"
#include "Testing/Benchmarks/Stopwatch.h"
#include "Testing/Support/RealData.h"

namespace falciform::bench {
namespace {

constexpr int kThreads = 2;
constexpr double kMovedMm = 5;

/// Organ voxels with a neighbour outside.
Mask borderOf(const Mask& mask) {
  Mask border = sameGrid<std::uint8_t>(mask, 0);
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    if (mask.voxels[i] != 0)
      eachFaceNeighbour(mask.size, i, [&](std::size_t n) { border.voxels[i] |= mask.voxels[n] == 0; });
  return border;
}

/// Distances from each border to the other's, both ways.
std::vector<float> surfaceDistances(const MaskPair& pair) {
  const Mask a = borderOf(pair.a), b = borderOf(pair.b);
  const Image toA = distanceTo(a), toB = distanceTo(b);
  std::vector<float> distances;
  for (std::size_t i = 0; i < a.voxels.size(); ++i) {
    if (a.voxels[i] != 0) distances.push_back(toB.voxels[i]);
    if (b.voxels[i] != 0) distances.push_back(toA.voxels[i]);
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

double mean(const std::vector<float>& values) {
  double sum = 0;
  for (const float value : values) sum += static_cast<double>(value);
  return sum / static_cast<double>(values.size());
}

std::vector<Vector3d> moved(std::vector<Vector3d> places, std::mt19937& generator) {
  std::normal_distribution<double> normal;
  for (Vector3d& place : places) {
    const Vector3d way(normal(generator), normal(generator), normal(generator));
    place += kMovedMm * way.normalized();
  }
  return places;
}

void row(const MaskedCt& liver, const Clicks& clicks, const Image& ct, const LabelMap& mask, int draws,
         const LevelSetSettings& settings = {}) {
  LevelSetResult result;
  const Spent spent =
      measured([&] { result = segmentLevelSet({.ct = ct, .seeds = pointsOf(clicks.places)}, settings); });
  const MaskPair pair = cropped(result.labels, mask, liver.label);
  const std::vector<float> distances = surfaceDistances(pair);
  const double maskMl = static_cast<double>(countOrgan(pair.b)) * ct.voxelVolume() / 1000;
  std::vector<double> spread;
  std::mt19937 generator(1);
  for (int draw = 0; draw < draws; ++draw) {
    const std::vector<Vector3d> places = moved(clicks.places, generator);
    spread.push_back(diceOf(
        cropped(segmentLevelSet({.ct = ct, .seeds = pointsOf(places)}, {}).labels, mask, liver.label)));
  }
  std::sort(spread.begin(), spread.end());
  std::printf("| %s | %s%s | %.3f | %.0f of %.0f | %.2f | %.1f | %.1f | %.1f | ", liver.name, clicks.what,
              settings.takeEnclosed ? "" : ", `--no-take-enclosed`", diceOf(pair), result.volumeMl, maskMl,
              mean(distances), static_cast<double>(distances[distances.size() * 95 / 100]),
              spent.wallMs / 1000, spent.cpuMs / 1000);
  if (spread.empty())
    std::printf("- |\n");
  else
    std::printf("%.3f to %.3f |\n", spread.front(), spread.back());
  for (const std::string& warning : result.warnings) std::fprintf(stderr, "  %s\n", warning.c_str());
  std::fflush(stdout);
}

int run(int draws) {
  setThreads(kThreads);
  std::printf("%d threads. Distances between the borders, both ways. Last column: %d draws.\n\n", kThreads,
              draws);
  std::puts(
      "| CT | clicks | Dice | volume, ml | mean distance, mm | 95 %, mm | s | processor s | Dice, each click "
      "moved 5 mm |\n"
      "|---|---|---|---|---|---|---|---|---|");
  for (const MaskedCt& liver : maskedCts()) {
    const auto ct = test::realData() / liver.ct, mask = test::realData() / liver.mask;
    if (!std::filesystem::exists(ct) || !std::filesystem::exists(mask)) {
      std::printf("| %s | needs %s |\n", liver.name, ct.string().c_str());
      continue;
    }
    const Image image = readImage(ct).value;
    const LabelMap labels = readLabelMap(mask).value;
    row(liver, liver.clicks.front(), image, labels, 0, {.takeEnclosed = false});
    for (const Clicks& clicks : liver.clicks) row(liver, clicks, image, labels, draws);
  }
  return 0;
}

}  // namespace
}  // namespace falciform::bench

int main(int argc, char** argv) { return falciform::bench::run(argc > 1 ? std::atoi(argv[1]) : 10); }
