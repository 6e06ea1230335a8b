#pragma once
#include <vector>

#include "Logic/Core/Surface.h"
#include "Logic/Core/Volume.h"

namespace falciform::bench {

/// Couinaud's segment at each of the surface's points, 1 to 8; 0 where the map has none within three voxels.
[[nodiscard]] std::vector<int> segmentsAtSurface(const Surface& liver, const LabelMap& segments);

/// Patches as a surgeon would paint them, from a map of Couinaud's segments 1 to 8 and the surface imported
/// from it (LPS): the falciform groove along the border of segment 4 with 2 and 3 on the front, about 8 mm
/// wide, and the sharp inferior margin. Throws InputError where either turns out too small to be used.
[[nodiscard]] std::vector<int> paintedBySegments(const Surface& liver, const LabelMap& segments);

}  // namespace falciform::bench
