#pragma once
#include <vector>

#include "Logic/Segmentation/LevelSetTissue.h"

namespace falciform {

/// Seeds that lie in tissue of one brightness.
struct SeedGroup {
  Tissue tissue;
  std::vector<Vector3d> seeds;  ///< continuous indices
  std::vector<Index> numbers;   ///< rows of the input, from 0
};

/// Sorts seeds by the brightness within `radiusMm` of each: first those like the first seed, which stands in
/// the organ's own tissue, then each seed unlike it (in a tumour, a vessel) by itself. `known` is the organ's
/// tissue where it is known already; its group comes first even without a seed.
[[nodiscard]] std::vector<SeedGroup> groupSeeds(const Image& image, const std::vector<Vector3d>& seeds,
                                                double radiusMm, const Tissue* known = nullptr);

}  // namespace falciform
