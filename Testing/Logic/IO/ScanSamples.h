#pragma once
#include <filesystem>
#include <string>

#include "Logic/Core/Surface.h"
#include "Logic/IO/ImageFiles.h"

namespace falciform::test {

/// rows x columns samples, 1 apart, of the sheet z = 300 + 0.1 x as a camera at the origin sees it that looks
/// along z: x to the right, y down. Sample (row, column) is point row * columns + column.
[[nodiscard]] Points tiltedSheet(int rows, int columns);

/// A PCD file of these points as rows x columns, colours (row, column, 7), missing where `missing` says so.
/// `coding`: ascii, binary or binary_compressed.
[[nodiscard]] std::string pcdOf(const Points& points, int rows, int columns, const std::vector<int>& missing,
                                const std::string& coding);

/// The same raster as a Stanford range grid in a text PLY, the first row of the grid lowest.
[[nodiscard]] std::string rangeGridOf(const Points& points, int rows, int columns,
                                      const std::vector<int>& missing);

/// Pixels whose red is their column and whose green is their row.
[[nodiscard]] ColourImage gradientImage(int width, int height);

/// Depths of the plane z = 500 + 2 (column - row), mm, 0 in the first column.
[[nodiscard]] DepthImage slantedDepths(int width, int height);

/// Share of triangles whose front faces `eye`.
[[nodiscard]] double facingShare(const Surface& surface, const Vector3d& eye);

/// A JPEG of 16 x 16 pixels, all (200, 60, 40) within a few grey values.
[[nodiscard]] std::string smallJpeg();

}  // namespace falciform::test
