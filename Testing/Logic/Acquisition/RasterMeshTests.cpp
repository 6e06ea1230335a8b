#include "Logic/Geometry/RasterMesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "Logic/Core/Draws.h"

namespace falciform {
namespace {

/// A square raster of points over z = height(x, y), seen from above: columns along x, rows along -y, 1 mm
/// apart.
struct Patch {
  Raster raster;
  Points points;
};

template <class Height>
Patch patchOf(int size, double jump, const Height& height) {
  Patch patch;
  patch.raster = {.rows = size, .columns = size, .point = {}, .range = {}, .jump = jump};
  patch.points.resize(size * size, 3);
  for (int row = 0, i = 0; row < size; ++row)
    for (int column = 0; column < size; ++column, ++i) {
      patch.points.row(i) << column, -row, height(column, -row);
      patch.raster.point.push_back(i);
      patch.raster.range.push_back(1000 - patch.points(i, 2));
    }
  return patch;
}

Vector3d areaVector(const Points& p, const Triangles& t, Index i) {
  const Vector3d a = p.row(t(i, 0)).transpose(), b = p.row(t(i, 1)).transpose(),
                 c = p.row(t(i, 2)).transpose();
  return (b - a).cross(c - a) / 2;
}

TEST(RasterMesh, CoversAPlaneOnceAndFacesTheScanner) {
  const Patch patch = patchOf(12, 5, [](double x, double y) { return 0.3 * x - 0.2 * y; });
  const Triangles triangles = rasterTriangles(patch.raster);
  EXPECT_EQ(triangles.rows(), 2 * 11 * 11);
  double projected = 0;
  for (Index i = 0; i < triangles.rows(); ++i) {
    EXPECT_GT(areaVector(patch.points, triangles, i).z(), 0);
    projected += areaVector(patch.points, triangles, i).z();
  }
  EXPECT_NEAR(projected, 121, 1e-9);  // mm2
}

TEST(RasterMesh, LeavesJumpsOpen) {
  const Patch patch = patchOf(10, 3, [](double x, double) { return x < 4.5 ? 0.0 : 10.0; });
  const Triangles triangles = rasterTriangles(patch.raster);
  EXPECT_EQ(triangles.rows(), 2 * 9 * 8);  // one column of cells is lost
  for (Index i = 0; i < triangles.rows(); ++i) {
    const double z = patch.points(triangles(i, 0), 2);
    EXPECT_EQ(patch.points(triangles(i, 1), 2), z);
    EXPECT_EQ(patch.points(triangles(i, 2), 2), z);
  }
}

TEST(RasterMesh, KeepsTheTriangleWhereACornerIsMissing) {
  for (const int missing : {0, 1, 2, 3}) {
    Patch patch = patchOf(2, 3, [](double, double) { return 0.0; });
    patch.raster.point[static_cast<std::size_t>(missing)] = -1;
    const Triangles triangles = rasterTriangles(patch.raster);
    ASSERT_EQ(triangles.rows(), 1) << missing;
    EXPECT_NEAR(areaVector(patch.points, triangles, 0).z(), 0.5, 1e-12);
  }
}

TEST(RasterMesh, NormalsOfANoisyPlaneAreThePlanes) {
  Draws draws(5);
  const Patch patch =
      patchOf(40, 8, [&](double x, double y) { return 0.5 * x + 0.25 * y + 0.3 * draws.normal(); });
  const Points normals = rasterNormals(patch.raster, patch.points, {20, -20, 1000});
  const Vector3d truth = Vector3d(-0.5, -0.25, 1).normalized();
  double sum = 0;
  for (Index i = 0; i < normals.rows(); ++i) {
    EXPECT_NEAR(normals.row(i).norm(), 1, 1e-12);
    sum += std::acos(std::min(1.0, normals.row(i).dot(truth))) * 180 / M_PI;
  }
  // 49 points with 0.3 mm noise over 7 mm: a slope error of 0.3 / (2 sqrt(49)) = 0.02, a little over 1
  // degree.
  EXPECT_LT(sum / static_cast<double>(normals.rows()), 3);
}

TEST(RasterMesh, ALonelyPointLooksAtTheScanner) {
  Patch patch = patchOf(1, 3, [](double, double) { return 0.0; });
  const Points normals = rasterNormals(patch.raster, patch.points, {0, 30, 40});
  EXPECT_LT((normals.row(0) - Eigen::RowVector3d(0, 0.6, 0.8)).norm(), 1e-12);
}

}  // namespace
}  // namespace falciform
