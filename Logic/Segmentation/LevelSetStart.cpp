#include "Logic/Segmentation/LevelSetStart.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/Core/PlaceText.h"
#include "Logic/Segmentation/EnclosedTissue.h"
#include "Logic/Segmentation/GridFilters.h"

namespace falciform {

namespace {

constexpr double kSeedRadiusMm = 6;  ///< of the neighbourhood that a click stands for
constexpr double kDeepMm = 6;
constexpr double kSmoothingMm = 2;  ///< of the membership, on the coarsest level
constexpr float kOpen = 0.55F;      ///< membership above which the front may enter
constexpr float kHalf = 0.5F;
constexpr double kAirHu = -500;  ///< no organ is darker

bool inside(const Vector3i& index, const Vector3i& size) {
  return (index.array() >= 0).all() && (index.array() < size.array()).all();
}

/// Closing by a ball of `radiusMm`: gaps narrower than twice it are filled.
void fillGaps(Volume<std::uint8_t>& region, double radiusMm) {
  if (!(radiusMm > 0)) return;
  const Image away = distanceTo(region);
  Volume<std::uint8_t> far = sameGrid<std::uint8_t>(region, 0);
  for (std::size_t i = 0; i < far.voxels.size(); ++i)
    far.voxels[i] = static_cast<double>(away.voxels[i]) > radiusMm;
  const Image back = distanceTo(far);
  for (std::size_t i = 0; i < far.voxels.size(); ++i)
    if (static_cast<double>(back.voxels[i]) > radiusMm) region.voxels[i] = 1;
}

/// What lies deeper than `kDeepMm`: neighbours' tissue and blurred edges have no part in it.
Volume<std::uint8_t> deepPart(const Volume<std::uint8_t>& region) {
  const Image depth = depthWithin(region);
  Volume<std::uint8_t> deep = sameGrid<std::uint8_t>(region, 0);
  for (std::size_t i = 0; i < deep.voxels.size(); ++i)
    deep.voxels[i] = static_cast<double>(depth.voxels[i]) > kDeepMm;
  return deep;
}

/// Grows one tissue twice: the second time with the statistics of all that the first growth found, which
/// makes the result depend little on where exactly the seeds are.
Growth growTissue(const Image& image, SeedGroup& group, bool parenchyma, const Image& forbidden,
                  const LevelSetSettings& settings, const Progress& progress) {
  std::vector<Vector3i> seeds;
  for (const Vector3d& seed : group.seeds) {
    const Vector3i voxel = seed.array().round().cast<int>();
    seeds.push_back(voxel.cwiseMax(0).cwiseMin(image.size - Vector3i::Ones()));
  }
  GrowthPlan plan;
  plan.neckMm = settings.neckMm;
  if (parenchyma) {
    plan.leastMl = settings.leastVolumeMl;
    plan.mostMl = settings.mostVolumeMl;
  }
  Growth growth;
  for (int pass = 0; pass < 2; ++pass) {
    const Image member = membership(image, group.tissue, settings.tissueWidth, kSmoothingMm);
    Volume<std::uint8_t> open = sameGrid<std::uint8_t>(member, 0);
    for (std::size_t i = 0; i < open.voxels.size(); ++i)
      open.voxels[i] = member.voxels[i] > kOpen && (forbidden.voxels.empty() || forbidden.voxels[i] < kHalf);
    growth = growFromSeeds(open, seeds, plan, progress.part(0.5 * pass, 0.5 * pass + 0.5));
    const std::vector<float> values = valuesIn(image, deepPart(growth.region));
    if (pass == 0 && !values.empty()) group.tissue = tissueOf(values);
  }
  return growth;
}

/// Takes in darker bodies that the parenchyma encloses for the most part, each as a tissue of its own, as if
/// it had been clicked.
void takeEnclosed(const Image& image, const Image& forbidden, const LevelSetSettings& settings,
                  LevelSetStart& start) {
  const Tissue& tissue = start.tissues[0].group.tissue;
  Volume<std::uint8_t> barred;
  if (!forbidden.voxels.empty()) {
    barred = sameGrid<std::uint8_t>(image, 0);
    for (std::size_t i = 0; i < barred.voxels.size(); ++i) barred.voxels[i] = forbidden.voxels[i] >= kHalf;
  }
  for (EnclosedBody& body : enclosedBodies(image, start.region, barred,
                                           {.darkHu = tissue.level - settings.tissueWidth * tissue.spread,
                                           .brightHu = tissue.level + settings.tissueWidth * tissue.spread,
                                           .leastRadiusMm = settings.fillMm})) {
    for (std::size_t i = 0; i < body.region.voxels.size(); ++i)
      start.region.voxels[i] |= body.region.voxels[i];
    start.enclosed.push_back({body.volumeMl, body.tissue.level, body.enclosedShare, body.place});
    start.tissues.push_back({{body.tissue, {}, {}}, std::move(body.region)});
  }
}

std::string seedList(const std::vector<Index>& numbers) {
  std::string text = numbers.size() == 1 ? "seed " : "seeds ";
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text += (i == 0 ? "" : i + 1 == numbers.size() ? " and " : ", ") + std::to_string(numbers[i] + 1);
  return text;
}

}  // namespace

LevelSetStart growStart(const PyramidLevel& level, const std::vector<Vector3d>& seeds, const Image& kept,
                        const Image& forbidden, const LevelSetSettings& settings, const Progress& progress) {
  LevelSetStart start;
  start.region = sameGrid<std::uint8_t>(level.image, 0);
  Image image = level.image;
  smooth(image, settings.noiseMm);
  Tissue known;
  if (!kept.voxels.empty()) {
    for (std::size_t i = 0; i < kept.voxels.size(); ++i) start.region.voxels[i] = kept.voxels[i] >= kHalf;
    known = tissueOf(valuesIn(image, start.region));
  }
  std::vector<SeedGroup> groups =
      groupSeeds(image, seeds, kSeedRadiusMm, kept.voxels.empty() ? nullptr : &known);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    SeedGroup& group = groups[g];
    if (group.tissue.level < kAirHu)
      throw InputError(seedList(group.numbers) + ": the place has " + roundedText(group.tissue.level, 0) +
                       " HU, which is air; click inside the organ");
    Volume<std::uint8_t> region = g == 0 ? start.region : sameGrid<std::uint8_t>(level.image, 0);
    if (!group.seeds.empty()) {
      const double from = static_cast<double>(g) / static_cast<double>(groups.size()),
                   to = static_cast<double>(g + 1) / static_cast<double>(groups.size());
      Growth growth = growTissue(image, group, g == 0, forbidden, settings, progress.part(from, to));
      if (g == 0) start.neckMm = growth.neckMm;
      if (growth.seedsApart && g == 0)
        start.warnings.push_back(
            seedList(group.numbers) +
            ": no way through like tissue joins them, so each grows by itself; check that "
            "all lie in the organ");
      for (const NarrowWay& way : growth.left) start.leftOut.push_back({way.neckMm, way.volumeMl, way.place});
      for (std::size_t i = 0; i < region.voxels.size(); ++i) region.voxels[i] |= growth.region.voxels[i];
    }
    if (g > 0)
      start.warnings.push_back(seedList(group.numbers) + ": tissue of " + roundedText(group.tissue.level, 0) +
                               " HU, unlike the organ's " + roundedText(groups[0].tissue.level, 0) +
                               " HU; it grows with its own brightness (a tumour) - check its border");
    for (std::size_t i = 0; i < region.voxels.size(); ++i) start.region.voxels[i] |= region.voxels[i];
    start.tissues.push_back({group, std::move(region)});
  }
  // A seed is organ whatever the image says.
  for (const Vector3d& seed : seeds)
    if (const Vector3i at = seed.array().round().cast<int>(); inside(at, level.image.size))
      start.region.at(at.x(), at.y(), at.z()) = 1;
  // Before the gaps are filled: a filled half of a tumour would hide the rest.
  if (settings.takeEnclosed && kept.voxels.empty()) takeEnclosed(image, forbidden, settings, start);
  fillGaps(start.region, settings.fillMm);
  if (!forbidden.voxels.empty())
    for (std::size_t i = 0; i < start.region.voxels.size(); ++i)
      if (forbidden.voxels[i] >= kHalf) start.region.voxels[i] = 0;
  return start;
}

}  // namespace falciform
