#pragma once
#include <functional>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Surface.h"
#include "Logic/Core/Volume.h"

namespace falciform {

/// Negative inside, about a distance in mm near the surface: it must not change by more than 2 mm over 1 mm.
using ImplicitFunction = std::function<double(const Vector3d&)>;
/// Lowest and highest corner, rows 0 and 1, mm.
using Box = Eigen::Matrix<double, 2, 3>;

/// Depth below the surface (positive inside) on a grid of `step` mm over `box`: exact within some cells of
/// the surface, of the right sign elsewhere. Blocks far from the surface cost one evaluation.
[[nodiscard]] Image sampleDepth(const ImplicitFunction& distance, const Box& box, double step,
                                const Progress& progress = {});

/// The level set as a closed, evenly meshed surface of `edgeLengthMm`, its vertices moved onto the zero by
/// Newton steps. `step`: of the grid it is first found on, mm; details below it are lost.
[[nodiscard]] Surface meshImplicit(const ImplicitFunction& distance, const Box& box, double step,
                                   double edgeLengthMm, const Progress& progress = {});

}  // namespace falciform
