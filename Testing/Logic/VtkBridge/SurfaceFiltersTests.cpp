#include "Logic/VtkBridge/SurfaceFilters.h"

#include <gtest/gtest.h>

#include <numbers>

#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

constexpr double kPi = std::numbers::pi;

/// Radius minus the distance to `centre`, positive inside, on a grid with the given index-to-world matrix.
Image ball(const Matrix4d& worldFromIndex, const Vector3i& size, const Vector3d& centre, double radius) {
  Image field;
  field.size = size;
  field.worldFromIndex = worldFromIndex;
  field.voxels.resize(static_cast<std::size_t>(size.prod()));
  for (int k = 0; k < size.z(); ++k)
    for (int j = 0; j < size.y(); ++j)
      for (int i = 0; i < size.x(); ++i)
        field.at(i, j, k) = static_cast<float>(radius - (field.world(Vector3d(i, j, k)) - centre).norm());
  return field;
}

Matrix4d grid(const Matrix3d& axes, const Vector3d& origin) {
  Matrix4d m = Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = axes;
  m.topRightCorner<3, 1>() = origin;
  return m;
}

/// Mean of a ball that fills the middle of the grid, checked against closed forms.
void expectBall(const Matrix4d& worldFromIndex, const Vector3i& size, double radius) {
  Image probe;
  probe.worldFromIndex = worldFromIndex;
  const Vector3d centre = probe.world((size.cast<double>() - Vector3d::Ones()) / 2);
  const Surface surface = isosurface(ball(worldFromIndex, size, centre, radius), 0);
  EXPECT_TRUE(inspectTopology(surface).closedManifold()) << describeTopology(inspectTopology(surface));
  // Linear interpolation of a distance field over voxels h: the error of each point is below h^2 / (4 r).
  const double h = probe.spacing().maxCoeff(), error = h * h / (4 * radius);
  const VectorXd radii = (surface.points.rowwise() - centre.transpose()).rowwise().norm();
  EXPECT_LT((radii.array() - radius).abs().maxCoeff(), error + 1e-3) << "mm; 1e-3 for single precision";
  // The polyhedron itself lies within another h^2 / (4 r) of its points.
  EXPECT_NEAR(signedVolume(surface) / (4 * kPi / 3 * std::pow(radius, 3)), 1, 6 * error / radius);
}

TEST(Isosurface, OfABallIsAClosedManifoldFacingOutwards) {
  expectBall(grid(Matrix3d::Identity(), {-20, 3, 100}), {45, 45, 45}, 20);
}

TEST(Isosurface, HonoursAnisotropicSpacing) {
  expectBall(grid(Vector3d(0.7, 0.8, 2.5).asDiagonal(), {1, 2, 3}), {65, 60, 20}, 20);
}

TEST(Isosurface, HonoursObliqueAxes) {
  const Matrix3d turn = test::randomMotion(11).linear();
  expectBall(grid(turn * Vector3d(1, 1.2, 2).asDiagonal(), {-7, 80, 9}), {45, 40, 25}, 20);
}

TEST(Isosurface, HonoursShear) {
  Matrix3d axes = Matrix3d::Identity();
  axes(0, 2) = 0.3;  // a tilted gantry
  expectBall(grid(axes, {0, 0, 0}), {60, 45, 45}, 20);
}

TEST(Isosurface, FacesOutwardsOnALeftHandedGrid) {
  expectBall(grid(Vector3d(-1, 1, 1).asDiagonal(), {0, 0, 0}), {45, 45, 45}, 20);
  Matrix3d swapped;
  swapped << 0, 1, 0, 1, 0, 0, 0, 0, 1;
  expectBall(grid(swapped, {5, 5, 5}), {45, 45, 45}, 20);
}

TEST(Isosurface, FacesTheSideOfLowerValues) {
  // A hole in a field that is larger outside: its surface faces the hole.
  Image field = ball(Matrix4d::Identity(), {45, 45, 45}, {22, 22, 22}, 20);
  for (float& value : field.voxels) value = -value;
  EXPECT_LT(signedVolume(isosurface(field, 0)), 0);
}

TEST(Isosurface, OfANonCubicGridKeepsItsAxesApart) {
  // One bright voxel at (1, 2, 3): the six points stand half-way to its neighbours.
  Image field;
  field.size = {4, 5, 7};
  field.voxels.assign(4 * 5 * 7, 0);
  field.at(1, 2, 3) = 1;
  const Surface surface = isosurface(field, 0.5);
  ASSERT_EQ(surface.size(), 6);
  EXPECT_LT((centroid(surface.points) - Vector3d(1, 2, 3)).norm(), 1e-6);
  EXPECT_NEAR(signedVolume(surface), 4.0 / 3 * 0.125, 1e-6) << "an octahedron of half-axis 1/2";
}

TEST(Isosurface, IsEmptyWhereTheLevelIsNotCrossedOrTheGridIsFlat) {
  Image field = ball(Matrix4d::Identity(), {9, 9, 9}, {4, 4, 4}, 3);
  EXPECT_EQ(isosurface(field, 50).triangles.rows(), 0);
  field.size = {81, 9, 1};
  EXPECT_EQ(isosurface(field, 0).triangles.rows(), 0);
  EXPECT_EQ(isosurface(Image{}, 0).size(), 0);
}

TEST(WindowedSinc, KeepsTopologyAndFlattensNoise) {
  Surface noisy = test::sphere(50, 5);
  noisy.patch.assign(static_cast<std::size_t>(noisy.size()), 2);
  for (Index i = 0; i < noisy.size(); ++i) noisy.points.row(i) *= 1 + (i % 7 - 3) * 0.004;  // up to 0.6 mm
  const Surface smooth = smoothWindowedSinc(noisy, 30, 0.05);
  EXPECT_EQ(smooth.triangles, noisy.triangles);
  EXPECT_EQ(smooth.patch, noisy.patch);
  const auto spread = [](const Surface& s) {
    const VectorXd r = s.points.rowwise().norm();
    return std::sqrt((r.array() - r.mean()).square().mean());
  };
  EXPECT_LT(spread(smooth), spread(noisy) / 4);
  EXPECT_NEAR(signedVolume(smooth) / signedVolume(noisy), 1, 0.01) << "a low-pass filter, not shrinkage";
}

TEST(WindowedSinc, LeavesBoundaryEdgesInPlace) {
  Surface sheet = test::grid(10, 10);
  for (Index i = 0; i < sheet.size(); ++i) sheet.points(i, 2) = (i * 37 % 11) * 0.1;
  const Surface smooth = smoothWindowedSinc(sheet, 20, 0.1);
  const Adjacency triangles = trianglesOfVertices(sheet.triangles, sheet.size());
  double moved = 0;
  for (int i = 0; i < sheet.size(); ++i) {
    const double step = (smooth.points.row(i) - sheet.points.row(i)).norm();
    const bool border = sheet.points(i, 0) < 0.1 || sheet.points(i, 0) > 9.9 || sheet.points(i, 1) < 0.1 ||
                        sheet.points(i, 1) > 9.9;
    if (border)
      EXPECT_LT(step, 1e-4) << "mm, single precision of VTK's filter";
    else
      moved = std::max(moved, step);
  }
  EXPECT_GT(moved, 0.1);
}

TEST(WindowedSinc, IsCovariantUnderRigidMotion) {
  const Surface body = test::lumpyBody(4);
  const Isometry3d motion = test::randomMotion(5, 300);
  const Surface a = transformed(smoothWindowedSinc(body, 30, 0.03), motion, "LPS");
  const Surface b = smoothWindowedSinc(transformed(body, motion, "LPS"), 30, 0.03);
  EXPECT_LT((a.points - b.points).rowwise().norm().maxCoeff(), 5e-3)
      << "mm, single precision of VTK's filter";
}

TEST(WindowedSinc, WithNoIterationsChangesNothing) {
  const Surface body = test::lumpyBody(3);
  EXPECT_EQ(smoothWindowedSinc(body, 0, 0.1).points, body.points);
  EXPECT_EQ(smoothWindowedSinc(Surface{}, 10, 0.1).size(), 0);
}

}  // namespace
}  // namespace falciform
