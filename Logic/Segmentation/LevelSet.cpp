#include "Logic/Segmentation/LevelSet.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Segmentation/GridFilters.h"
#include "Logic/Segmentation/LevelSetChecks.h"
#include "Logic/Segmentation/LevelSetFront.h"
#include "Logic/Segmentation/LevelSetInput.h"
#include "Logic/Segmentation/LevelSetSpeed.h"
#include "Logic/Segmentation/LevelSetStart.h"
#include "Logic/Segmentation/RegionPieces.h"

namespace falciform {

namespace {

constexpr int kCoarseRounds = 2;    ///< edges are measured anew for each
constexpr int kSteps = 12;          ///< time steps of a round
constexpr double kAtRest = 0.02;    ///< mean speed at which a round ends early
constexpr double kMarginMm = 10;    ///< of the finer levels' boxes around the organ
constexpr double kEdgeMm = 3;       ///< how far from the border its two sides are looked at
constexpr double kLeakWidth = 1.5;  ///< necks up to so many times the front's own are looked at
constexpr double kWideNeckMm = 10, kMuchWider = 2.5;
constexpr double kLeastNeckMm = 4;       ///< for maps that one goes on from
constexpr double kLeakShare = 0.01;      ///< of the organ's volume: smaller parts are not worth a word
constexpr float kAnyHu = 1e6F;           ///< beyond any brightness
constexpr std::size_t kEnough = 200000;  ///< values that statistics need

/// One tissue as the level set sees it on the level at hand.
struct MovingTissue {
  Tissue tissue;  // of the smoothed image
  Image away;     // distance to what the first growth found of it; empty for the parenchyma
  TissueLimits limits;
};

/// What is known on the level at hand.
struct Stage {
  PyramidLevel level;
  Image smoothed, phi, anchor;  // anchor: signed distance to the first growth's border
  Image kept, forbidden;        // shares; empty if there are none
  std::vector<MovingTissue> tissues;
};

std::vector<float> fewer(const std::vector<float>& values) {
  const std::size_t step = values.size() / kEnough + 1;
  std::vector<float> some;
  for (std::size_t i = 0; i < values.size(); i += step) some.push_back(values[i]);
  return some;
}

void measureLimits(Stage& stage, MovingTissue& tissue, double width) {
  const Image member = membership(stage.smoothed, tissue.tissue, width, 0);
  tissue.limits = tissueLimits(stage.smoothed, member, stage.phi, tissue.tissue, {.width = width});
}

/// s of Eq. (II.1) with all that bounds it: a second tissue only near where it grew, no place farther than
/// the reach from the first growth, what the user kept or forbade.
Image speedOf(const Stage& stage, double reachMm) {
  Image speed = regionSpeed(stage.smoothed, stage.tissues[0].limits, stage.tissues[0].tissue);
  const auto reach = static_cast<float>(std::max(reachMm, 1e-3));
  for (std::size_t t = 1; t < stage.tissues.size(); ++t) {
    const MovingTissue& tissue = stage.tissues[t];
    const Image own = regionSpeed(stage.smoothed, tissue.limits, tissue.tissue);
    for (std::size_t i = 0; i < own.voxels.size(); ++i)
      if (tissue.away.voxels[i] <= reach) speed.voxels[i] = std::max(speed.voxels[i], own.voxels[i]);
  }
  forEachChunk(speed.voxels.size(), 65536, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      float& s = speed.voxels[i];
      const float beyond = stage.anchor.voxels[i] / reach;
      s *= std::clamp(s > 0 ? 1 - beyond : 1 + beyond, 0.0F, 1.0F);
      if (!stage.kept.voxels.empty() && stage.kept.voxels[i] >= 0.5F) s = std::max(s, 0.0F);
      if (!stage.forbidden.voxels.empty() && stage.forbidden.voxels[i] > 0.5F) s = -1;
    }
  });
  return speed;
}

Mask maskOf(const Image& phi) {
  Mask mask = sameGrid<std::uint8_t>(phi, 0);
  for (std::size_t i = 0; i < phi.voxels.size(); ++i) mask.voxels[i] = phi.voxels[i] < 0;
  return mask;
}

void evolve(Stage& stage, const LevelSetSettings& settings, int rounds, const Progress& progress,
            const LevelSetPreview& preview) {
  LevelSetFront front(stage.phi, {.curvature = settings.curvature, .patienceMm = settings.patienceMm});
  for (int round = 0; round < rounds; ++round) {
    if (round > 0)
      for (MovingTissue& tissue : stage.tissues) measureLimits(stage, tissue, settings.tissueWidth);
    const Image speed = speedOf(stage, settings.reachMm);
    for (int step = 0; step < kSteps; ++step) {
      progress.report((round + static_cast<double>(step) / kSteps) / rounds, "Moving the front");
      const bool atRest = front.advance(speed) < kAtRest;
      if (preview) preview(maskOf(front.phi()));
      if (atRest) break;
    }
    stage.phi = front.phi();
  }
}

Stage firstStage(PyramidLevel level, const LevelSetStart& start, Image kept, Image forbidden,
                 const LevelSetSettings& settings) {
  Stage stage{std::move(level),     {}, signedDistance(start.region), {}, std::move(kept),
              std::move(forbidden), {}};
  stage.anchor = stage.phi;
  stage.smoothed = stage.level.image;
  smooth(stage.smoothed, settings.noiseMm);
  for (std::size_t t = 0; t < start.tissues.size(); ++t) {
    MovingTissue tissue;
    const std::vector<float> values = valuesIn(stage.smoothed, start.tissues[t].region);
    tissue.tissue = values.empty() ? start.tissues[t].group.tissue : tissueOf(fewer(values));
    if (t > 0) tissue.away = distanceTo(start.tissues[t].region);
    stage.tissues.push_back(std::move(tissue));
    measureLimits(stage, stage.tissues.back(), settings.tissueWidth);
  }
  return stage;
}

/// The box of the organ with a margin, as turned indices of the stored volume, one block more than the volume
/// at most on each side.
std::pair<Vector3i, Vector3i> boxOf(const Stage& stage, const StorageOrder& order, const Vector3i& factor) {
  Vector3d low = order.size.cast<double>(), high = Vector3d::Zero();
  const Image& phi = stage.phi;
  for (int k = 0; k < phi.size.z(); ++k)
    for (int j = 0; j < phi.size.y(); ++j)
      for (int i = 0; i < phi.size.x(); ++i)
        if (phi.at(i, j, k) < 0) {
          const Vector3d at = stage.level.toStored(Vector3d(i, j, k));
          low = low.cwiseMin(at);
          high = high.cwiseMax(at);
        }
  const Vector3d margin =
      kMarginMm * order.worldFromIndex.topLeftCorner<3, 3>().colwise().norm().cwiseInverse().transpose();
  return {
      (low - margin).array().floor().cast<int>().matrix().cwiseMax(-factor),
      (high + margin).array().ceil().cast<int>().matrix().cwiseMin(order.size - Vector3i::Ones() + factor)};
}

/// Farther from the front than the coarse level followed it, nothing will move: there inside is organ,
/// outside is not, and nothing is computed.
Stage finerStage(const Stage& coarse, PyramidLevel level, const LevelSetSettings& settings) {
  Stage stage{std::move(level), {}, {}, {}, {}, {}, {}};
  stage.phi = resampled(coarse.phi, coarse.level, stage.level);
  float width = 0;
  for (const float value : coarse.phi.voxels) width = std::max(width, std::abs(value));
  Mask far = sameGrid<std::uint8_t>(stage.phi, 0);
  for (std::size_t i = 0; i < far.voxels.size(); ++i)
    far.voxels[i] = std::abs(stage.phi.voxels[i]) > 0.999F * width;
  const auto here = [&](const Image& image) { return resampled(image, coarse.level, stage.level, &far); };
  stage.anchor = here(coarse.anchor);
  stage.smoothed = stage.level.image;
  smooth(stage.smoothed, settings.noiseMm);
  for (const MovingTissue& before : coarse.tissues) {
    MovingTissue tissue{before.tissue,
                        before.away.voxels.empty() ? Image{} : here(before.away),
                        {here(before.limits.low), here(before.limits.high)}};
    for (std::size_t i = 0; i < far.voxels.size(); ++i)
      if (far.voxels[i] != 0) {
        tissue.limits.low.voxels[i] = stage.phi.voxels[i] < 0 ? -kAnyHu : kAnyHu;
        tissue.limits.high.voxels[i] = kAnyHu;
      }
    stage.tissues.push_back(std::move(tissue));
  }
  return stage;
}

/// Keeps the pieces that hold a seed or something to go on from, or else the largest.
void keepSeeded(Mask& mask, const std::vector<Vector3d>& seeds, const Image& kept) {
  const std::vector<RegionPiece> pieces = piecesOf(mask);
  if (pieces.size() < 2) return;
  std::vector<char> wanted(mask.voxels.size(), 0);
  for (const Vector3d& seed : seeds) {
    const Vector3i at =
        seed.array().round().cast<int>().matrix().cwiseMax(0).cwiseMin(mask.size - Vector3i::Ones());
    wanted[mask.offset(at.x(), at.y(), at.z())] = 1;
  }
  for (std::size_t i = 0; i < kept.voxels.size(); ++i) wanted[i] |= kept.voxels[i] >= 0.5F;
  const RegionPiece* largest = &pieces.front();
  std::vector<char> keep(pieces.size(), 0);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (pieces[p].voxels.size() > largest->voxels.size()) largest = &pieces[p];
    for (const std::size_t voxel : pieces[p].voxels)
      if (wanted[voxel] != 0) keep[p] = 1;
  }
  keep[static_cast<std::size_t>(largest - pieces.data())] = 1;
  for (std::size_t p = 0; p < pieces.size(); ++p)
    if (keep[p] == 0)
      for (const std::size_t voxel : pieces[p].voxels) mask.voxels[voxel] = 0;
}

/// Background from which no way leads out of the grid.
void fillEnclosed(Mask& mask, const Image& forbidden) {
  std::vector<std::size_t> way;
  std::vector<std::uint8_t> reached(mask.voxels.size(), 0);
  const auto enter = [&](std::size_t voxel) {
    if (mask.voxels[voxel] != 0 || reached[voxel] != 0) return;
    reached[voxel] = 1;
    way.push_back(voxel);
  };
  for (int k = 0; k < mask.size.z(); ++k)
    for (int j = 0; j < mask.size.y(); ++j)
      for (int i = 0; i < mask.size.x(); ++i)
        if (i == 0 || j == 0 || k == 0 || i + 1 == mask.size.x() || j + 1 == mask.size.y() ||
            k + 1 == mask.size.z())
          enter(mask.offset(i, j, k));
  for (std::size_t next = 0; next < way.size(); ++next) eachFaceNeighbour(mask.size, way[next], enter);
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    if (reached[i] == 0 && (forbidden.voxels.empty() || forbidden.voxels[i] <= 0.5F)) mask.voxels[i] = 1;
}

/// By necks a little wider than the front's own, and by wider ones if what hangs on them is much wider still.
std::vector<LeftOut> suspiciousParts(const Mask& mask, double neckMm) {
  const double leastMl = kLeakShare * static_cast<double>(countOrgan(mask)) * mask.voxelVolume() / 1000;
  std::vector<LeftOut> parts =
      partsBehindNecks(mask, kLeakWidth * std::max(neckMm, kLeastNeckMm), 1, leastMl);
  return parts.empty() ? partsBehindNecks(mask, kWideNeckMm, kMuchWider, leastMl) : parts;
}

/// The finest level's mask, put where it belongs in the stored volume.
LabelMap storedLabels(const Mask& mask, const PyramidLevel& level, const StorageOrder& order,
                      const Image& ct) {
  LabelMap labels{ct.size, ct.worldFromIndex, std::vector<std::uint16_t>(ct.voxels.size(), 0)};
  for (int k = 0; k < mask.size.z(); ++k)
    for (int j = 0; j < mask.size.y(); ++j)
      for (int i = 0; i < mask.size.x(); ++i) {
        const Vector3i at = level.origin + Vector3i(i, j, k);
        if ((at.array() < 0).any() || (at.array() >= order.size.array()).any()) continue;
        labels.voxels[order.offset(at.x(), at.y(), at.z())] = mask.at(i, j, k);
      }
  return labels;
}

}  // namespace

LevelSetResult segmentLevelSet(const LevelSetInput& input, const LevelSetSettings& settings,
                               const Progress& progress, const LevelSetPreview& preview) {
  checkSettings(settings);
  checkLevelSetInput(input);
  progress.report(0, "Coarsening the volume");
  const StorageOrder order = canonicalOrder(input.ct.size, input.ct.worldFromIndex);
  const std::vector<Vector3d> stored = storedSeeds(input.seeds, order);
  const auto onLevel = [&](const PyramidLevel& level) {
    std::vector<Vector3d> seeds;
    for (const Vector3d& seed : stored) seeds.push_back(level.fromStored(seed));
    return seeds;
  };
  const auto shareOf = [&](const LabelMap* map, const PyramidLevel& level) {
    return map == nullptr ? Image{} : coarsenedShare(*map, order, level);
  };

  const std::vector<Vector3i> factors = pyramidFactors(input.ct.spacing(), settings.coarsestMm);
  PyramidLevel level =
      coarsened(input.ct, order, factors[0], -factors[0], order.size - Vector3i::Ones() + factors[0]);
  Image kept = shareOf(input.start, level), forbidden = shareOf(input.forbidden, level);
  LevelSetStart start = growStart(level, onLevel(level), kept, forbidden, settings, progress.part(0.05, 0.3));
  if (preview) preview(start.region);

  Stage stage = firstStage(std::move(level), start, std::move(kept), std::move(forbidden), settings);
  LevelSetResult result;
  result.tissueLevelHu = start.tissues[0].group.tissue.level;
  result.tissueSpreadHu = start.tissues[0].group.tissue.spread;
  result.neckMm = start.neckMm;
  result.leftOut = std::move(start.leftOut);
  result.enclosed = std::move(start.enclosed);
  result.warnings = std::move(start.warnings);
  std::vector<LeftOut> behindNecks;
  for (std::size_t f = 0; f < factors.size(); ++f) {
    const double from = 0.3 + 0.65 * static_cast<double>(f) / static_cast<double>(factors.size()),
                 to = 0.3 + 0.65 * static_cast<double>(f + 1) / static_cast<double>(factors.size());
    if (f > 0) {
      progress.report(from, "Refining");
      const auto [low, high] = boxOf(stage, order, factors[f]);
      stage = finerStage(stage, coarsened(input.ct, order, factors[f], low, high), settings);
      stage.kept = shareOf(input.start, stage.level);
      stage.forbidden = shareOf(input.forbidden, stage.level);
    }
    evolve(stage, settings, f == 0 ? kCoarseRounds : 1, progress.part(from, to), preview);
    Mask mask = maskOf(stage.phi);
    keepSeeded(mask, onLevel(stage.level), stage.kept);
    if (preview) preview(mask);
    if (f == 0) {
      result.weakBorderShare = weakBorderShare(stage.smoothed, stage.phi, stage.tissues[0].tissue, kEdgeMm);
      behindNecks = suspiciousParts(mask, result.neckMm);
    }
    if (f + 1 < factors.size()) {
      for (MovingTissue& tissue : stage.tissues) measureLimits(stage, tissue, settings.tissueWidth);
      continue;
    }
    progress.report(0.96, "Tidying up");
    if (settings.fillCavities) fillEnclosed(mask, stage.forbidden);
    if (!stage.forbidden.voxels.empty())
      for (std::size_t i = 0; i < mask.voxels.size(); ++i)
        if (stage.forbidden.voxels[i] > 0.5F) mask.voxels[i] = 0;
    result.labels = storedLabels(mask, stage.level, order, input.ct);
    result.volumeMl = static_cast<double>(std::count(result.labels.voxels.begin(), result.labels.voxels.end(),
                                                     std::uint16_t{1})) *
                      input.ct.voxelVolume() / 1000;
  }
  warnOfLeaks(result, settings, behindNecks, sidesTouched(result.labels, order));
  progress.report(1);
  return result;
}

}  // namespace falciform
