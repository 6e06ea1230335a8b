#pragma once
#include <cmath>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// The kept returns of a range scanner in the order of its raster.
struct Raster {
  int rows = 0, columns = 0;
  std::vector<int>
      point;  ///< rows x columns, columns fastest: index of the point, -1 where there is no return
  std::vector<double> range;  ///< rows x columns, mm along the ray
  double jump = 0;  ///< two neighbours in the raster are joined if their ranges differ by at most this, mm

  [[nodiscard]] std::size_t at(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  [[nodiscard]] bool joined(std::size_t a, std::size_t b) const {
    return point[a] >= 0 && point[b] >= 0 && std::abs(range[a] - range[b]) <= jump;
  }
};

/// Two triangles a cell along the shorter step in range, one where a corner is missing, none across a jump.
/// Rows run downwards and columns to the right as the scanner sees them, so the triangles face the scanner.
[[nodiscard]] Triangles rasterTriangles(const Raster& raster);

/// Unit normals of planes fitted to each point's neighbourhood in the raster (three cells each way, not
/// across jumps), towards `eye`. A point with too few neighbours looks straight at the eye.
[[nodiscard]] Points rasterNormals(const Raster& raster, const Points& points, const Vector3d& eye);

}  // namespace falciform
