#pragma once
#include <array>
#include <cstdint>

#include "Logic/Core/Types.h"

namespace falciform {

/// How a scanner's camera sees the liver at a place of its surface: brownish-red parenchyma, mildly mottled,
/// paler along the falciform ligament. The mottling belongs to the place, so that two scans of one liver
/// agree.
[[nodiscard]] std::array<std::uint8_t, 3> tissueColour(const Vector3d& place, int patchLabel);

}  // namespace falciform
