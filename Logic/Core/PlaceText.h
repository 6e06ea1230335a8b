#pragma once
#include <charconv>
#include <string>

#include "Logic/Core/Types.h"

namespace falciform {

/// With so many digits after the point, C locale.
[[nodiscard]] inline std::string roundedText(double value, int digits) {
  char buffer[64];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, digits).ptr};
}

/// "(12, -34, 56) mm": a place in an error or a warning.
[[nodiscard]] inline std::string placeText(const Vector3d& mm) {
  return "(" + roundedText(mm.x(), 0) + ", " + roundedText(mm.y(), 0) + ", " + roundedText(mm.z(), 0) +
         ") mm";
}

}  // namespace falciform
