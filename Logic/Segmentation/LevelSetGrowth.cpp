#include "Logic/Segmentation/LevelSetGrowth.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "Logic/Segmentation/GridFilters.h"
#include "Logic/Segmentation/RegionPieces.h"

namespace falciform {

namespace {

constexpr double kSeedReachMm = 6;  ///< a click may miss by so much

/// The narrowest place on the widest way from any of the sources, for every voxel: fast marching whose front
/// always advances where it is widest. Ties go to the lower voxel, so the order is fixed.
Image widestWay(const Image& depth, const std::vector<std::size_t>& sources) {
  Image way = sameGrid(depth, 0.0F);
  using Entry = std::pair<float, std::size_t>;
  const auto later = [](const Entry& a, const Entry& b) {
    return a.first != b.first ? a.first < b.first : a.second > b.second;
  };
  std::priority_queue<Entry, std::vector<Entry>, decltype(later)> front(later);
  for (const std::size_t source : sources) {
    way.voxels[source] = depth.voxels[source];
    front.emplace(depth.voxels[source], source);
  }
  const Vector3i size = depth.size;
  while (!front.empty()) {
    const auto [width, here] = front.top();
    front.pop();
    if (width < way.voxels[here]) continue;
    const auto h = static_cast<int>(here);
    const int x = h % size.x(), y = h / size.x() % size.y(), z = h / size.x() / size.y();
    for (int dz = std::max(z - 1, 0); dz <= std::min(z + 1, size.z() - 1); ++dz)
      for (int dy = std::max(y - 1, 0); dy <= std::min(y + 1, size.y() - 1); ++dy)
        for (int dx = std::max(x - 1, 0); dx <= std::min(x + 1, size.x() - 1); ++dx) {
          const std::size_t there = depth.offset(dx, dy, dz);
          const float passed = std::min(width, depth.voxels[there]);
          if (passed <= way.voxels[there]) continue;
          way.voxels[there] = passed;
          front.emplace(passed, there);
        }
  }
  return way;
}

/// All that the balls of `radius` cover whose middles the front reached.
Volume<std::uint8_t> covered(const Image& way, double radius) {
  Volume<std::uint8_t> middles = sameGrid<std::uint8_t>(way, 0);
  for (std::size_t i = 0; i < way.voxels.size(); ++i)
    middles.voxels[i] = static_cast<double>(way.voxels[i]) >= radius;
  const Image distance = distanceTo(middles);
  for (std::size_t i = 0; i < way.voxels.size(); ++i)
    middles.voxels[i] = static_cast<double>(distance.voxels[i]) < radius;
  return middles;
}

std::size_t deepestNear(const Image& depth, const Vector3i& seed) {
  const Vector3d spacing = depth.spacing();
  std::size_t best = depth.offset(seed.x(), seed.y(), seed.z());
  double bestScore = static_cast<double>(depth.voxels[best]);
  const Vector3i reach = (kSeedReachMm / spacing.array()).cast<int>();
  for (int k = -reach.z(); k <= reach.z(); ++k)
    for (int j = -reach.y(); j <= reach.y(); ++j)
      for (int i = -reach.x(); i <= reach.x(); ++i) {
        const Vector3i at = seed + Vector3i(i, j, k);
        if ((at.array() < 0).any() || (at.array() >= depth.size.array()).any()) continue;
        const double away = Vector3d(i, j, k).cwiseProduct(spacing).norm();
        if (away > kSeedReachMm) continue;
        const std::size_t there = depth.offset(at.x(), at.y(), at.z());
        const double score = static_cast<double>(depth.voxels[there]);
        if (score > bestScore) {
          bestScore = score;
          best = there;
        }
      }
  return best;
}

/// What `wider` has beyond `narrower` grown by a voxel and a half, as pieces that should not be entered:
/// their depth is set to 0.
std::vector<NarrowWay> closeNewPieces(const Volume<std::uint8_t>& narrower, const Volume<std::uint8_t>& wider,
                                      double radius, double volumeMl, const std::vector<std::size_t>& sources,
                                      const GrowthPlan& plan, Image& depth) {
  const Image distance = distanceTo(narrower);
  const double skin = 1.5 * narrower.spacing().maxCoeff();
  Volume<std::uint8_t> gained = wider;
  for (std::size_t i = 0; i < gained.voxels.size(); ++i)
    if (static_cast<double>(distance.voxels[i]) <= skin) gained.voxels[i] = 0;
  std::vector<NarrowWay> ways;
  for (const RegionPiece& piece : piecesOf(gained)) {
    double reach = 0;
    for (const std::size_t voxel : piece.voxels)
      reach = std::max(reach, static_cast<double>(distance.voxels[voxel]));
    if (std::any_of(sources.begin(), sources.end(), [&](std::size_t source) {
          return std::binary_search(piece.voxels.begin(), piece.voxels.end(), source);
        }))
      continue;
    const double share = piece.volumeMl(gained) / volumeMl;
    if (share < plan.pieceShare && (share < plan.tubeShare || reach < plan.tubeReach * radius)) continue;
    ways.push_back({radius, piece.volumeMl(gained), gained.world(piece.middle)});
    for (const std::size_t voxel : piece.voxels) depth.voxels[voxel] = 0;
  }
  return ways;
}

double millilitres(const Volume<std::uint8_t>& flags) {
  return static_cast<double>(std::count(flags.voxels.begin(), flags.voxels.end(), std::uint8_t{1})) *
         flags.voxelVolume() / 1000;
}

}  // namespace

Growth growFromSeeds(const Volume<std::uint8_t>& open, const std::vector<Vector3i>& seeds,
                     const GrowthPlan& plan, const Progress& progress) {
  progress.report(0, "Growing from the seeds");
  Image depth = depthWithin(open);
  for (float& value : depth.voxels) value = std::min(value, static_cast<float>(4 * plan.widestMm));

  std::vector<std::size_t> sources;
  for (const Vector3i& seed : seeds) sources.push_back(deepestNear(depth, seed));
  Growth growth;
  progress.report(0.2);
  const Image fromFirst = widestWay(depth, {sources.front()});
  growth.seedNeckMm = 4 * plan.widestMm;
  for (const std::size_t source : sources)
    growth.seedNeckMm = std::min(growth.seedNeckMm, static_cast<double>(fromFirst.voxels[source]));
  progress.report(0.4);
  Image way = sources.size() > 1 ? widestWay(depth, sources) : fromFirst;

  const double narrowest = std::max(plan.narrowestMm, 1.01 * open.spacing().maxCoeff());
  growth.seedsApart = growth.seedNeckMm < narrowest;
  const double step = 0.5 * open.spacing().minCoeff();
  // Wide at first, so that nothing has slipped in unseen; no wider than the roomiest seed's place.
  double roomiest = 0;
  for (const std::size_t source : sources)
    roomiest = std::max(roomiest, static_cast<double>(depth.voxels[source]));
  double radius = plan.neckMm > 0 ? plan.neckMm : std::clamp(roomiest, narrowest, plan.widestMm);
  growth.region = covered(way, radius);
  const double last = std::max(step, std::min(narrowest, radius - step)) - 1e-9;
  for (double next = radius - step; next >= last; next -= step) {
    progress.report(0.4 + 0.6 * std::clamp(1 - next / plan.widestMm, 0.0, 1.0));
    const double volume = millilitres(growth.region);
    Volume<std::uint8_t> wider = covered(way, next);
    if (volume < plan.leastMl && millilitres(wider) <= plan.mostMl) {
      growth.region = std::move(wider);
      radius = next;
      continue;
    }
    const std::vector<NarrowWay> ahead =
        closeNewPieces(growth.region, wider, next, volume, sources, plan, depth);
    double appeared = 0;
    for (const NarrowWay& piece : ahead) appeared += piece.volumeMl;
    growth.left.insert(growth.left.end(), ahead.begin(), ahead.end());
    if (plan.neckMm > 0 || appeared > plan.leakShare * volume) break;
    if (!ahead.empty()) {
      way = widestWay(depth, sources);
      wider = covered(way, next);
    }
    growth.region = std::move(wider);
    radius = next;
  }
  if (plan.leastMl > 0 && millilitres(growth.region) < plan.leastMl) {
    // Smaller than any such organ even so: then nothing was gained by looking away.
    GrowthPlan strict = plan;
    strict.leastMl = 0;
    return growFromSeeds(open, seeds, strict, progress);
  }
  growth.neckMm = radius;
  std::stable_sort(growth.left.begin(), growth.left.end(),
                   [](const NarrowWay& a, const NarrowWay& b) { return a.volumeMl > b.volumeMl; });
  return growth;
}

}  // namespace falciform
