#pragma once
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform::verification {

/// A place in a tetrahedron by its barycentric coordinates, and its share of the volume.
struct QuadraturePlace {
  Eigen::Vector4d barycentric;
  double weight;
};

/// Gauss-Legendre points of a cube collapsed onto the tetrahedron (Stroud's conical product), 5 a direction:
/// exact for polynomials to degree 7, and no rule that the solver uses.
[[nodiscard]] const std::vector<QuadraturePlace>& finePlaces();

}  // namespace falciform::verification
