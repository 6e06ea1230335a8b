#include "Logic/Segmentation/LevelSetSpeed.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Segmentation/GridFilters.h"

namespace falciform {

namespace {

constexpr std::size_t kChunk = 65536;

/// Means over boxes, with the weights' sums; `fallback` where the weights are next to nothing.
Image boxMean(Image weighted, Image weights, const Vector3i& half, double least, float fallback) {
  sumOverBox(weighted, half);
  sumOverBox(weights, half);
  forEachChunk(weighted.voxels.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      weighted.voxels[i] =
          static_cast<double>(weights.voxels[i]) > least ? weighted.voxels[i] / weights.voxels[i] : fallback;
  });
  return weighted;
}

}  // namespace

TissueLimits tissueLimits(const Image& image, const Image& member, const Image& phi, const Tissue& tissue,
                          const SpeedPlan& plan) {
  const Vector3d spacing = image.spacing();
  const Vector3i half = (plan.windowMm / spacing.array()).round().cast<int>();
  const double boxVoxels = static_cast<double>((2 * half + Vector3i::Ones()).prod());
  const auto level = static_cast<float>(tissue.level), contrast = static_cast<float>(plan.contrastHu),
             reach = static_cast<float>(plan.width * tissue.spread),
             skin = static_cast<float>(0.5 * spacing.minCoeff());

  /// side 0: inside; -1, 1: outside and darker, brighter
  const auto meanOf = [&](int side) {
    Image weighted = sameGrid(image, 0.0F), weights = weighted;
    forEachChunk(image.voxels.size(), kChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const float other = 1 - member.voxels[i];
        float weight = 0;
        if (side == 0)
          weight = phi.voxels[i] < -skin ? member.voxels[i] : 0;
        else if (phi.voxels[i] > skin && (image.voxels[i] > level) == (side > 0))
          weight = other * other;
        weights.voxels[i] = weight;
        weighted.voxels[i] = weight * std::clamp(image.voxels[i], level - contrast, level + contrast);
      }
    });
    return boxMean(std::move(weighted), std::move(weights), half, 0.01 * boxVoxels,
                   level + static_cast<float>(side) * reach);
  };
  const Image inside = meanOf(0), darker = meanOf(-1), brighter = meanOf(1);
  TissueLimits limits{darker, brighter};
  forEachChunk(image.voxels.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      limits.low.voxels[i] = std::min((inside.voxels[i] + darker.voxels[i]) / 2, level - reach);
      limits.high.voxels[i] = std::max((inside.voxels[i] + brighter.voxels[i]) / 2, level + reach);
    }
  });
  return limits;
}

Image regionSpeed(const Image& image, const TissueLimits& limits, const Tissue& tissue) {
  Image speed = sameGrid(image, 0.0F);
  const auto spread = static_cast<float>(tissue.spread);
  forEachChunk(image.voxels.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      speed.voxels[i] = std::clamp(
          std::min(image.voxels[i] - limits.low.voxels[i], limits.high.voxels[i] - image.voxels[i]) / spread,
          -1.0F, 1.0F);
  });
  return speed;
}

}  // namespace falciform
