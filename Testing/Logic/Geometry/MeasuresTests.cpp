#include "Logic/Geometry/Measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

constexpr double kPi = std::numbers::pi;
/// Rounding of sums of a few thousand doubles of the size of 1e4.
constexpr double kRounding = 1e-8;

TEST(Measures, BoxHasTheClosedFormAreaAndVolume) {
  const Surface box = test::box({2, 3, 5});
  EXPECT_NEAR(area(box), 2 * (6 + 10 + 15), kRounding);
  EXPECT_NEAR(signedVolume(box), 30, kRounding);
}

TEST(Measures, SphereConvergesQuadratically) {
  double before = 0;
  for (int level = 2; level <= 5; ++level) {
    const Surface sphere = test::sphere(10, level);
    const double areaError = 1 - area(sphere) / (400 * kPi);
    const double volumeError = 1 - signedVolume(sphere) / (4000 * kPi / 3);
    EXPECT_GT(areaError, 0) << "an inscribed surface is smaller";
    if (before > 0) {
      EXPECT_NEAR(before / volumeError, 4, 0.2) << "halved edges";
    }
    before = volumeError;
  }
  EXPECT_LT(before, 2e-3);
}

TEST(Measures, VolumeChangesSignWhenTurnedInsideOutAndNotWhenMoved) {
  Surface torus = test::torus(20, 5, 60, 30);
  const double volume = signedVolume(torus);
  EXPECT_NEAR(volume / (2 * kPi * kPi * 20 * 25), 1, 0.02) << "60 x 30 segments inscribed";
  // A kilometre away: the error must stay that of doubles on the body's own size.
  const Surface far = transformed(torus, test::randomMotion(3, 1e6), "LPS");
  EXPECT_NEAR(signedVolume(far), volume, 1e-4 * volume / 1e2);
  torus.triangles.col(0).swap(torus.triangles.col(1));
  EXPECT_NEAR(signedVolume(torus), -volume, kRounding);
}

TEST(Measures, VertexAreasSumToTheAreaAndAreOnesForClouds) {
  Surface body = test::lumpyBody(3);
  EXPECT_NEAR(vertexAreas(body).sum(), area(body), 1e-9 * area(body));
  body.triangles.resize(0, 3);
  EXPECT_EQ(vertexAreas(body), VectorXd::Ones(body.size()));
}

TEST(Measures, NormalsOfASphereAreRadial) {
  const Surface sphere = test::sphere(10, 4, {5, 6, 7});
  const Points normals = vertexNormals(sphere);
  for (Index i = 0; i < sphere.size(); ++i) {
    const Vector3d radial = (sphere.points.row(i).transpose() - Vector3d(5, 6, 7)) / 10;
    EXPECT_GT(normals.row(i).dot(radial), std::cos(0.01)) << "0.01 rad: a seventh of the edges' angle";
    EXPECT_NEAR(normals.row(i).norm(), 1, 1e-12);
  }
}

TEST(Measures, NormalsWeighByAngleSoThatTheCutOfAFaceDoesNotMatter) {
  // At a box's corner each face spans 90 degrees in one or two triangles: the angle-weighted mean is the
  // diagonal.
  const Points normals = vertexNormals(test::box({2, 2, 2}));
  for (Index i = 0; i < 8; ++i)
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(normals(i, c), (i >> c & 1 ? 1 : -1) / std::sqrt(3.0), 1e-12);
}

TEST(Measures, NormalsAreZeroWhereThereIsNoTriangle) {
  Surface surface = test::box({1, 1, 1});
  surface.points.conservativeResize(9, 3);
  surface.points.row(8).setOnes();
  EXPECT_EQ(vertexNormals(surface).row(8).norm(), 0);
}

TEST(Measures, BoxAndCentroidAndEdgesInClosedForm) {
  const Surface grid = test::grid(10, 5);
  const auto corners = boundingBox(grid.points);
  EXPECT_EQ(Vector3d(corners.row(0)), Vector3d(0, 0, 0));
  EXPECT_EQ(Vector3d(corners.row(1)), Vector3d(10, 10, 0));
  EXPECT_LT((centroid(grid.points) - Vector3d(5, 5, 0)).norm(), 1e-12);
  const double straight = 2 * 5 * 6, diagonal = 25;
  EXPECT_NEAR(meanEdgeLength(grid), 2 * (straight + diagonal * std::numbers::sqrt2) / (straight + diagonal),
              1e-12);
}

TEST(Measures, NothingHasNoMeasure) {
  const Surface empty;
  EXPECT_EQ(area(empty), 0);
  EXPECT_EQ(signedVolume(empty), 0);
  EXPECT_EQ(meanEdgeLength(empty), 0);
  EXPECT_EQ(boundingBox(empty.points).norm(), 0);
  EXPECT_EQ(centroid(empty.points).norm(), 0);
  EXPECT_EQ(vertexNormals(empty).rows(), 0);
}

}  // namespace
}  // namespace falciform
