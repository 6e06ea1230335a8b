#pragma once
#include <optional>
#include <string>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

// What surfaces and meshes have in common when they are read. Inside Logic/IO only.

/// Sets `frame` by a file's space tag; world is LPS, so RAS points are turned by 180 degrees about the third
/// axis, which keeps the sense of triangles and tetrahedra. Warns where there is no tag. True if turned.
bool honourSpace(Points& points, std::string& frame, const std::optional<std::string>& space,
                 const std::string& name, std::vector<std::string>& warnings);

/// Throws InputError for coordinates beyond any operating theatre; warns of extents that look like metres or
/// micrometres.
void checkUnits(const Points& points, const std::string& name, std::vector<std::string>& warnings);

}  // namespace falciform
