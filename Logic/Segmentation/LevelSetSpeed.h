#pragma once
#include "Logic/Segmentation/LevelSetTissue.h"

namespace falciform {

struct SpeedPlan {
  double width = 2.5;       ///< spreads from the level at which tissue ends where no edge says better
  double windowMm = 8;      ///< half the box in which an edge's two sides are measured
  double contrastHu = 150;  ///< values farther from the level than this count as this far: air and bone
};

/// Between which two values a voxel is the organ's, place by place.
struct TissueLimits {
  Image low, high;
};

/// Tissue ends `width` spreads from its level; where what lies outside the front in the neighbourhood is
/// clearly darker or brighter, half-way between the two sides, so that the border sits in the middle of a
/// blurred edge. `phi` is the front, negative inside; `image` the smoothed CT; `member` its membership.
[[nodiscard]] TissueLimits tissueLimits(const Image& image, const Image& member, const Image& phi,
                                        const Tissue& tissue, const SpeedPlan& plan);

/// What the image says of each voxel: 1 surely organ, -1 surely not, 0 on the limit, one spread between.
[[nodiscard]] Image regionSpeed(const Image& image, const TissueLimits& limits, const Tissue& tissue);

}  // namespace falciform
