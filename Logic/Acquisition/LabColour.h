#pragma once
#include "Logic/Core/Types.h"

namespace falciform {

/// N x 3 CIE L*a*b* values (D65) of sRGB colours: lightness 0 to 100, red against green, yellow against blue.
/// Distances in it are about those that the eye sees.
[[nodiscard]] Points labOf(const Colours& colours);

}  // namespace falciform
