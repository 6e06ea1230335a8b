#pragma once
#include <cstdint>
#include <vector>

#include "Logic/Core/Volume.h"

namespace falciform {

/// The organ's brightness in Hounsfield units: median and robust standard deviation (1.4826 x the median
/// distance from the median), voxel noise included.
struct Tissue {
  double level = 0, spread = 1;
};

/// Of these values; the spread is at least `kLeastSpread`.
[[nodiscard]] Tissue tissueOf(std::vector<float> values);
inline constexpr double kLeastSpread = 4;  ///< HU: no scanner's parenchyma is more even

/// The values within `radiusMm` of a continuous index, in storage order.
[[nodiscard]] std::vector<float> valuesAround(const Image& image, const Vector3d& index, double radiusMm);

/// The values of the flagged voxels, in storage order.
[[nodiscard]] std::vector<float> valuesIn(const Image& image, const Volume<std::uint8_t>& flags);

/// How much each voxel is the organ's tissue, in [0, 1]: 1 at its level, 1/2 at `width` spreads from it,
/// averaged by a Gaussian of `smoothingMm`, since one noisy voxel says little.
[[nodiscard]] Image membership(const Image& image, const Tissue& tissue, double width, double smoothingMm);

}  // namespace falciform
