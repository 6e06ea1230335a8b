#pragma once
#include <gtest/gtest.h>

#include <Eigen/Core>

#include <string>

#include "Widgets/Rendering/RenderedImage.h"

namespace falciform::test {

/// Compares with Baselines/NAME.png. Fonts and rasterisers of other Mesa versions may shift edges by a pixel:
/// at most 2 % of pixels may differ by more than 40 of 255 in a channel, and the mean difference stays below
/// 2 of 255. On failure the picture is saved and the message says where. FALCIFORM_UPDATE_BASELINES=1 writes
/// the baselines instead.
[[nodiscard]] testing::AssertionResult matchesBaseline(const RenderedImage& image, const std::string& name);

/// Pixels of `image` whose channels all lie within `tolerance` of 255 of `colour` (red, green, blue in [0,
/// 1]).
[[nodiscard]] int countColour(const RenderedImage& image, const Eigen::Vector3d& colour, int tolerance);

}  // namespace falciform::test
