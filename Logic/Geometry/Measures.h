#pragma once
#include "Logic/Core/Surface.h"

namespace falciform {

/// Sum of triangle areas, mm^2.
[[nodiscard]] double area(const Surface& surface);
/// Enclosed volume, mm^3, by the divergence theorem; positive when triangles face outwards. Meaningful if
/// closed.
[[nodiscard]] double signedVolume(const Surface& surface);
/// Over every edge once, mm; 0 if there is none.
[[nodiscard]] double meanEdgeLength(const Surface& surface);
/// Mean of the points; zero if there are none.
[[nodiscard]] Vector3d centroid(const Points& points);
/// Axis-aligned, rows 0 and 1: lowest and highest corner; zeros if there are no points.
[[nodiscard]] Eigen::Matrix<double, 2, 3> boundingBox(const Points& points);
/// A third of the area of the triangles around each vertex, N values, mm^2; ones for a cloud.
[[nodiscard]] VectorXd vertexAreas(const Surface& surface);
/// N x 3 unit normals, angle-weighted mean of the triangles around each vertex; zero where there is none.
[[nodiscard]] Points vertexNormals(const Surface& surface);

}  // namespace falciform
