#pragma once
#include "Logic/Core/Volume.h"
#include "Logic/Geometry/GridField.h"

namespace falciform {

/// An image on a lattice over a surface's box and `marginMm` around it: each value the mean of eight places
/// in its cell; air (-1000) beyond the image.
[[nodiscard]] GridField imageField(const Image& image, const Surface& around, double cellMm, double marginMm);

}  // namespace falciform
