#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "Logic/Core/Volume.h"

namespace falciform {

/// 1 in the organ, 0 elsewhere. The outer `kMaskMargin` layers are background, so that a surface around it
/// closes.
using Mask = Volume<std::uint8_t>;
inline constexpr int kMaskMargin = 2;

/// The part of the map around the voxels whose value `isOrgan` says (65536 flags), with the margin added, on
/// the axes of canonicalAxes. Empty (size 0) if there is no such voxel.
[[nodiscard]] Mask cutOut(const LabelMap& map, const std::vector<char>& isOrgan);

struct ComponentCounts {
  std::size_t pieces = 0;         ///< 6-connected pieces found
  std::size_t droppedVoxels = 0;  ///< of all pieces but the largest
};
/// Keeps the largest 6-connected piece; of equal ones, the first in storage order.
ComponentCounts keepLargestComponent(Mask& mask);

/// Turns background that has no 6-connected way to the margin into organ; returns how many voxels.
std::size_t fillCavities(Mask& mask);

[[nodiscard]] std::size_t countOrgan(const Mask& mask);

}  // namespace falciform
