#pragma once
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform {

/// Two triangles that cut through or touch each other where they should not.
struct Crossing {
  int first = -1, second = -1;        ///< triangles
  Vector3d place = Vector3d::Zero();  ///< mm: a place of both
};

/// Pairs of a surface's triangles that meet elsewhere than in the vertices they share; duplicates and folds
/// flat onto themselves too. `first` < `second`, ascending. What rounding cannot tell from touching counts as
/// touching.
[[nodiscard]] std::vector<Crossing> selfCrossings(const Surface& surface);

/// Pairs of a triangle of `one` and a triangle of `other` that meet, ascending.
[[nodiscard]] std::vector<Crossing> crossings(const Surface& one, const Surface& other);

}  // namespace falciform
