#pragma once
#include <vector>

#include "Logic/Segmentation/LevelSet.h"
#include "Logic/Segmentation/StorageOrder.h"

namespace falciform {

/// Throws InputError where the input cannot be segmented: what, value, remedy.
void checkLevelSetInput(const LevelSetInput& input);

/// Continuous turned indices of the seeds.
[[nodiscard]] std::vector<Vector3d> storedSeeds(const Points& seeds, const StorageOrder& order);

}  // namespace falciform
