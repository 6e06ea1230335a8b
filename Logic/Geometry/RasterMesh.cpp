#include "Logic/Geometry/RasterMesh.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "Logic/Core/Parallel.h"

namespace falciform {
namespace {

constexpr int kWindow =
    3;  // cells each way: a plane over about 7 mm averages the noise and keeps the curvature
constexpr int kFewest = 6;  // points that a plane needs to be trusted
constexpr std::size_t kRowsChunk = 8;

Vector3d planeNormal(const Raster& raster, const Points& points, int row, int column) {
  const std::size_t centre = raster.at(row, column);
  const Vector3d origin =
      points.row(raster.point[centre]).transpose();  // near-by origin keeps the sums exact
  Vector3d sum = Vector3d::Zero();
  Matrix3d squares = Matrix3d::Zero();
  int count = 0;
  for (int r = std::max(row - kWindow, 0); r <= std::min(row + kWindow, raster.rows - 1); ++r)
    for (int c = std::max(column - kWindow, 0); c <= std::min(column + kWindow, raster.columns - 1); ++c) {
      const std::size_t other = raster.at(r, c);
      const int steps = std::max({std::abs(r - row), std::abs(c - column), 1});
      if (raster.point[other] < 0 ||
          std::abs(raster.range[other] - raster.range[centre]) > raster.jump * steps)
        continue;
      const Vector3d d = points.row(raster.point[other]).transpose() - origin;
      sum += d;
      squares += d * d.transpose();
      ++count;
    }
  if (count < kFewest) return Vector3d::Zero();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(squares - sum * sum.transpose() / count);
  return axes.eigenvalues()[1] > 0 ? Vector3d(axes.eigenvectors().col(0)) : Vector3d::Zero();
}

}  // namespace

Triangles rasterTriangles(const Raster& raster) {
  std::vector<std::array<int, 3>> found;
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    if (raster.joined(a, b) && raster.joined(b, c) && raster.joined(c, a))
      found.push_back({raster.point[a], raster.point[b], raster.point[c]});
  };
  for (int row = 0; row + 1 < raster.rows; ++row)
    for (int column = 0; column + 1 < raster.columns; ++column) {
      const std::size_t a = raster.at(row, column), b = raster.at(row, column + 1);
      const std::size_t c = raster.at(row + 1, column), d = raster.at(row + 1, column + 1);
      const bool mainWhole = raster.point[a] >= 0 && raster.point[d] >= 0;
      const bool otherWhole = raster.point[b] >= 0 && raster.point[c] >= 0;
      const bool alongMain = mainWhole && (!otherWhole || std::abs(raster.range[a] - raster.range[d]) <=
                                                              std::abs(raster.range[b] - raster.range[c]));
      if (alongMain) {
        add(a, c, d);
        add(a, d, b);
      } else {
        add(a, c, b);
        add(b, c, d);
      }
    }
  Triangles triangles(static_cast<Index>(found.size()), 3);
  for (std::size_t i = 0; i < found.size(); ++i)
    triangles.row(static_cast<Index>(i)) << found[i][0], found[i][1], found[i][2];
  return triangles;
}

Points rasterNormals(const Raster& raster, const Points& points, const Vector3d& eye) {
  Points normals = Points::Zero(points.rows(), 3);
  forEachChunk(static_cast<std::size_t>(raster.rows), kRowsChunk, [&](std::size_t begin, std::size_t end) {
    for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
      for (int column = 0; column < raster.columns; ++column) {
        const int i = raster.point[raster.at(row, column)];
        if (i < 0) continue;
        const Vector3d towardsEye = (eye - points.row(i).transpose()).normalized();
        Vector3d n = planeNormal(raster, points, row, column);
        if (n.isZero()) n = towardsEye;
        normals.row(i) = (n.dot(towardsEye) < 0 ? -n : n).transpose();
      }
  });
  return normals;
}

}  // namespace falciform
