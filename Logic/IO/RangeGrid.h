#pragma once
#include <optional>
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform {

/// Which point each sample of a raster found. Inside Logic/IO only.
struct RangeGrid {
  int rows = 0, columns = 0;
  std::vector<int> point;  ///< rows x columns, columns fastest; -1: no return
};

/// Gives the points of a raster triangles, and normals if they have none, facing `eye`; without an eye,
/// facing where rows run downwards and columns to the right. Neighbours are not joined across a jump: a step
/// in range steeper than 80 degrees for the raster's usual step.
void joinRaster(Surface& surface, const RangeGrid& grid, const std::optional<Vector3d>& eye);

/// Takes out the points that are not finite, and their samples from `grid`; returns how many. The surface
/// must have no triangles yet.
Index dropMissing(Surface& surface, RangeGrid& grid);

}  // namespace falciform
