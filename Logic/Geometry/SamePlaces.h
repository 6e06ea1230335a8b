#pragma once
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// For each point the first of those in exactly the same place: so that a surface stored triangle by triangle
/// (as STL is) has edges that join.
[[nodiscard]] std::vector<int> firstInSamePlace(const Points& points);

}  // namespace falciform
