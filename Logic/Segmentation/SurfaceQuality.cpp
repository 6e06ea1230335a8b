#include "Logic/Segmentation/SurfaceQuality.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Crossings.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {
namespace {

constexpr std::size_t kChunk = 1024;

/// The faces between organ and background, two triangles each.
Surface voxelFaces(const Mask& mask) {
  std::vector<Vector3d> corners;
  for (int k = 1; k + 1 < mask.size.z(); ++k)
    for (int j = 1; j + 1 < mask.size.y(); ++j)
      for (int i = 1; i + 1 < mask.size.x(); ++i) {
        if (mask.at(i, j, k) == 0) continue;
        for (int axis = 0; axis < 3; ++axis)
          for (const int side : {-1, 1}) {
            const Vector3i there = Vector3i(i, j, k) + side * Vector3i::Unit(axis);
            if (mask.at(there.x(), there.y(), there.z()) != 0) continue;
            const Vector3d middle = Vector3d(i, j, k) + side * Vector3d::Unit(axis) / 2;
            const Vector3d u = Vector3d::Unit((axis + 1) % 3) / 2, v = Vector3d::Unit((axis + 2) % 3) / 2;
            for (const Vector3d& c : {Vector3d(middle - u - v), Vector3d(middle + u - v),
                                      Vector3d(middle + u + v), Vector3d(middle - u + v)})
              corners.push_back(mask.world(c));
          }
      }
  Surface faces;
  faces.points.resize(static_cast<Index>(corners.size()), 3);
  for (std::size_t i = 0; i < corners.size(); ++i)
    faces.points.row(static_cast<Index>(i)) = corners[i].transpose();
  faces.triangles.resize(faces.points.rows() / 2, 3);
  for (int q = 0; q < static_cast<int>(faces.points.rows() / 4); ++q) {
    faces.triangles.row(2 * q) << 4 * q, 4 * q + 1, 4 * q + 2;
    faces.triangles.row(2 * q + 1) << 4 * q, 4 * q + 2, 4 * q + 3;
  }
  return faces;
}

/// Distances of `count` places, place(i), to the surface of the tree.
template <class Place>
std::vector<double> distances(const TriangleTree& tree, std::size_t count, Place place) {
  std::vector<double> all(count);
  forEachChunk(count, kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      all[i] = tree.closestAnySide(place(static_cast<Index>(i))).distance;
  });
  return all;
}

}  // namespace

SurfaceQuality measureQuality(const Surface& surface, const Mask& mask) {
  SurfaceQuality quality;
  quality.crossings = static_cast<Index>(selfCrossings(surface).size());
  quality.meanEdgeMm = meanEdgeLength(surface);
  const Surface faces = voxelFaces(mask);
  std::vector<double> all = distances(
      TriangleTree(surface), static_cast<std::size_t>(faces.points.rows() / 4), [&](Index face) -> Vector3d {
        return faces.points.middleRows(4 * face, 4).colwise().mean().transpose();
      });
  const std::vector<double> back =
      distances(TriangleTree(faces), static_cast<std::size_t>(surface.size()),
                [&](Index vertex) -> Vector3d { return surface.points.row(vertex).transpose(); });
  all.insert(all.end(), back.begin(), back.end());
  quality.meanMm = std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
  const auto p95 = all.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), p95, all.end());
  quality.p95Mm = *p95;
  quality.maxMm = *std::max_element(p95, all.end());
  return quality;
}

}  // namespace falciform
