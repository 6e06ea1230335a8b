#pragma once
#include <array>
#include <span>
#include <string_view>

#include "Logic/Core/Surface.h"

namespace falciform {

/// The length that a scan's numbers count.
enum class LengthUnit { Automatic, Millimetres, Centimetres, Metres, Micrometres };

inline std::span<const std::string_view> enumNames(LengthUnit) {
  static constexpr std::array<std::string_view, 5> names{"auto", "mm", "cm", "m", "um"};
  return names;
}

/// Millimetres in one of these; 1 for Automatic.
[[nodiscard]] double millimetresIn(LengthUnit unit);

/// The unit in which the scan's longest side is that of an opened abdomen, and whether there is any doubt.
struct UnitGuess {
  LengthUnit unit = LengthUnit::Millimetres;
  double extent = 0;     ///< longest side of the box, in the file's numbers
  bool certain = false;  ///< in no other unit would it be larger than 20 mm and smaller than 3 m
};
[[nodiscard]] UnitGuess guessUnit(const Points& points);

}  // namespace falciform
