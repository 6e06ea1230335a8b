#pragma once
#include "Logic/Core/Surface.h"
#include "Logic/Core/Volume.h"

namespace falciform {

/// The label of the voxel nearest to each point of a surface among those with a label above 0 whose centre
/// lies within `reachMm`; 0 where there is none. Ties go to the voxel that comes first in the file.
[[nodiscard]] VectorXd labelsAtPoints(const Points& pointsLps, const LabelMap& labels, double reachMm);

}  // namespace falciform
