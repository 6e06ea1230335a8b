// ./run bench segmentation-leaks [DRAWS]: the level set from three clicks anywhere in the liver's mask,
// vessels and tumours included, on the two real CTs with a mask (Docs/Segmentation.md). How often is it
// wrong, and does it say so?
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "Logic/Core/Draws.h"
#include "Logic/Core/Parallel.h"
#include "Logic/IO/VolumeFiles.h"
#include "Logic/Segmentation/GridFilters.h"
#include "Logic/Segmentation/LevelSet.h"
#include "Testing/Benchmarks/MaskedCts.h"
#include "Testing/Support/RealData.h"

namespace falciform::bench {
namespace {

constexpr int kThreads = 2, kClicks = 3;
constexpr double kDeepMm = 5;   // clicks lie so deep in the mask: a hand that aims at the organ hits it
constexpr double kFarMm = 5;    // what lies farther outside the mask is no matter of where the border runs
constexpr double kLeakMl = 30;  // of that, and it is a leak
constexpr double kPoorDice = 0.88;

/// Places at least kDeepMm inside the mask.
std::vector<Vector3d> deepPlaces(const LabelMap& mask, int label) {
  Mask outside = sameGrid<std::uint8_t>(mask, 0);
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    outside.voxels[i] = label == 0 ? mask.voxels[i] == 0 : mask.voxels[i] != label;
  const Image depth = distanceTo(outside);
  std::vector<Vector3d> places;
  for (int k = 0; k < mask.size.z(); ++k)
    for (int j = 0; j < mask.size.y(); ++j)
      for (int i = 0; i < mask.size.x(); ++i)
        if (depth.at(i, j, k) >= kDeepMm) places.push_back(mask.world(Vector3d(i, j, k)));
  return places;
}

/// ml of the result farther than kFarMm outside the mask.
double leakedMl(const MaskPair& pair) {
  const Image away = distanceTo(pair.b);
  std::size_t count = 0;
  for (std::size_t i = 0; i < pair.a.voxels.size(); ++i)
    count += pair.a.voxels[i] != 0 && static_cast<double>(away.voxels[i]) > kFarMm;
  return static_cast<double>(count) * pair.a.voxelVolume() / 1000;
}

void table(const MaskedCt& liver, int draws) {
  const Image ct = readImage(test::realData() / liver.ct).value;
  const LabelMap mask = readLabelMap(test::realData() / liver.mask).value;
  const std::vector<Vector3d> places = deepPlaces(mask, liver.label);
  std::vector<double> dice;
  int leaks = 0, leaksSaid = 0, poor = 0, poorSaid = 0, good = 0, goodSaid = 0;
  for (int draw = 0; draw < draws; ++draw) {
    Draws random(static_cast<std::uint64_t>(draw), 77);
    std::vector<Vector3d> clicks;
    for (int c = 0; c < kClicks; ++c)
      clicks.push_back(
          places[static_cast<std::size_t>(random.uniform() * static_cast<double>(places.size()))]);
    const LevelSetResult result = segmentLevelSet({.ct = ct, .seeds = pointsOf(clicks)}, {});
    const MaskPair pair = cropped(result.labels, mask, liver.label);
    const double match = diceOf(pair), leaked = leakedMl(pair);
    // What was taken in as enclosed is told in any case: that one says nothing of leaks.
    const bool warned = result.warnings.size() > (result.enclosed.empty() ? 0u : 1u), leak = leaked > kLeakMl,
               isPoor = match < kPoorDice;
    dice.push_back(match);
    leaks += leak;
    leaksSaid += leak && warned;
    poor += isPoor;
    poorSaid += isPoor && warned;
    good += !leak && !isPoor;
    goodSaid += warned && !leak && !isPoor;
    std::fprintf(stderr, "%s draw %d: Dice %.3f, %.0f ml far outside%s\n", liver.name, draw, match, leaked,
                 warned ? "" : ", nothing said");
    for (const std::string& warning : result.warnings) std::fprintf(stderr, "    %s\n", warning.c_str());
  }
  std::sort(dice.begin(), dice.end());
  std::printf("| %s | %d | %.3f, %.3f, %.3f | %d of %d | %d of %d | %d of %d |\n", liver.name, draws,
              dice.front(), dice[dice.size() / 2], dice.back(), leaksSaid, leaks, poorSaid, poor, goodSaid,
              good);
  std::fflush(stdout);
}

int run(int draws) {
  setThreads(kThreads);
  std::printf(
      "Three clicks at random places of the mask, at least %.0f mm deep. A leak: more than %.0f ml farther "
      "than "
      "%.0f mm outside the mask. Poor: Dice below %.2f.\n\n",
      kDeepMm, kLeakMl, kFarMm, kPoorDice);
  std::puts(
      "| CT | draws | Dice: least, median, largest | leaks told | poor ones told | others warned of "
      "|\n|---|---|---|---|---|---|");
  for (const MaskedCt& liver : maskedCts()) {
    if (!std::filesystem::exists(test::realData() / liver.ct)) continue;
    table(liver, draws);
  }
  return 0;
}

}  // namespace
}  // namespace falciform::bench

int main(int argc, char** argv) { return falciform::bench::run(argc > 1 ? std::atoi(argv[1]) : 30); }
