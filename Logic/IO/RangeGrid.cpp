#include "Logic/IO/RangeGrid.h"

#include <algorithm>
#include <cmath>

#include "Logic/Geometry/RasterMesh.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {

namespace {

constexpr double kSteepest = 5.67;  // tan 80 deg: flatter to the ray than this a scanner sees nothing
constexpr double kFar = 1e3;        // extents: rays from there are nearly parallel

/// Median distance of samples beside each other, along rows and columns; 0 if there are none.
double usualStep(const Points& points, const RangeGrid& grid) {
  std::vector<double> steps;
  const auto at = [&](int row, int column) {
    return grid.point[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
                      static_cast<std::size_t>(column)];
  };
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const int here = at(row, column);
      if (here < 0) continue;
      for (const int there : {column + 1 < grid.columns ? at(row, column + 1) : -1,
                              row + 1 < grid.rows ? at(row + 1, column) : -1})
        if (there >= 0) steps.push_back((points.row(here) - points.row(there)).norm());
    }
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// Sum of the triangles' areas as vectors: the side that most of the surface faces.
Vector3d facing(const Points& points, const Triangles& triangles) {
  Vector3d sum = Vector3d::Zero();
  for (Index t = 0; t < triangles.rows(); ++t) {
    const Vector3d a = points.row(triangles(t, 0)), b = points.row(triangles(t, 1)),
                   c = points.row(triangles(t, 2));
    sum += (b - a).cross(c - a);
  }
  return sum;
}

void setRanges(Raster& raster, const Points& points, const Vector3d& eye) {
  for (std::size_t i = 0; i < raster.point.size(); ++i)
    raster.range[i] = raster.point[i] < 0 ? 0 : (points.row(raster.point[i]).transpose() - eye).norm();
}

}  // namespace

void joinRaster(Surface& surface, const RangeGrid& grid, const std::optional<Vector3d>& eye) {
  const double step = usualStep(surface.points, grid);
  if (!(step > 0) || grid.rows < 2 || grid.columns < 2) return;
  Raster raster{.rows = grid.rows,
                .columns = grid.columns,
                .point = grid.point,
                .range = std::vector<double>(grid.point.size()),
                .jump = kSteepest * std::sqrt(2.0) * step};
  const Vector3d middle = surface.points.colwise().mean();
  Vector3d from = eye.value_or(middle);
  if (!eye) {
    // Ranges are all alike at first, so that every neighbour is joined: which side do they face?
    const Vector3d side = facing(surface.points, rasterTriangles(raster));
    const double extent = (surface.points.rowwise() - middle.transpose()).rowwise().norm().maxCoeff();
    from += kFar * extent * (side.norm() > 0 ? Vector3d(side.normalized()) : Vector3d::UnitZ());
  }
  setRanges(raster, surface.points, from);
  surface.triangles = rasterTriangles(raster);
  if (facing(surface.points, surface.triangles).dot(from - middle) < 0)
    surface.triangles.col(1).swap(surface.triangles.col(2));
  if (surface.normals.rows() == 0) surface.normals = rasterNormals(raster, surface.points, from);
}

Index dropMissing(Surface& surface, RangeGrid& grid) {
  std::vector<int> keep, now(static_cast<std::size_t>(surface.size()), -1);
  for (Index i = 0; i < surface.size(); ++i)
    if (surface.points.row(i).allFinite()) {
      now[static_cast<std::size_t>(i)] = static_cast<int>(keep.size());
      keep.push_back(static_cast<int>(i));
    }
  const Index missing = surface.size() - static_cast<Index>(keep.size());
  if (missing == 0) return 0;
  surface = subset(surface, keep);
  for (int& point : grid.point)
    if (point >= 0) point = now[static_cast<std::size_t>(point)];
  return missing;
}

}  // namespace falciform
