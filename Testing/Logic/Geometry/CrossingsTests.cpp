#include "Logic/Geometry/Crossings.h"

#include <gtest/gtest.h>

#include <random>

#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using test::sphere;

Surface pair(const Matrix3d& a, const Matrix3d& b) {
  Surface surface;
  surface.points.resize(6, 3);
  surface.points << a, b;
  surface.triangles.resize(2, 3);
  surface.triangles << 0, 1, 2, 3, 4, 5;
  return surface;
}

/// Whether a segment passes through a triangle, by solving for the place: for triangles in general position.
bool passes(const Vector3d& p, const Vector3d& q, const Matrix3d& t) {
  Matrix3d columns;
  columns << (t.row(1) - t.row(0)).transpose(), (t.row(2) - t.row(0)).transpose(), p - q;
  const Vector3d x = columns.fullPivLu().solve(p - t.row(0).transpose());
  return x[0] > 0 && x[1] > 0 && x[0] + x[1] < 1 && x[2] > 0 && x[2] < 1;
}

bool cross(const Matrix3d& a, const Matrix3d& b) {
  for (int k = 0; k < 3; ++k)
    if (passes(a.row(k).transpose(), a.row((k + 1) % 3).transpose(), b) ||
        passes(b.row(k).transpose(), b.row((k + 1) % 3).transpose(), a))
      return true;
  return false;
}

TEST(Crossings, OfTwoTrianglesAreThoseOfTheirEquations) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  int found = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    Matrix3d a, b;
    for (double& x : a.reshaped()) x = unit(random);
    for (double& x : b.reshaped()) x = unit(random);
    const auto crossings = selfCrossings(pair(a, b));
    EXPECT_EQ(!crossings.empty(), cross(a, b)) << trial;
    found += !crossings.empty();
  }
  EXPECT_GT(found, 500);
}

TEST(Crossings, AreNoneInSoundSurfaces) {
  for (const Surface& surface : {sphere(40, 4), test::box({30, 20, 10}), test::torus(40, 15, 40, 20),
                                 test::lumpyBody(4), test::grid(10, 8)})
    EXPECT_TRUE(selfCrossings(surface).empty());
}

TEST(Crossings, OfTwoBallsLieOnTheirCommonCircle) {
  const Surface one = sphere(20, 3), other = sphere(20, 3, {13, 3, 1});
  const auto found = crossings(one, other);
  ASSERT_GT(found.size(), 20U);
  const Vector3d between = Vector3d(13, 3, 1) / 2;
  for (const Crossing& crossing : found)  // 1 mm: facets of an edge of 3 mm
    EXPECT_NEAR((crossing.place - between).dot(between.normalized()), 0, 1);
  EXPECT_TRUE(crossings(one, sphere(5, 2)).empty());
  EXPECT_TRUE(crossings(one, sphere(5, 2, {40, 0, 0})).empty());
}

TEST(Crossings, CountDuplicatesFoldsAndTouches) {
  Matrix3d a;
  a << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  Surface twice = pair(a, a);
  twice.triangles.row(1) = twice.triangles.row(0);
  EXPECT_EQ(selfCrossings(twice).size(), 1U);
  Surface fold;  // two triangles over one edge, on the same side of it
  fold.points.resize(4, 3);
  fold.points << 0, 0, 0, 1, 0, 0, 0.2, 1, 0, 0.6, 0.7, 0;
  fold.triangles.resize(2, 3);
  fold.triangles << 0, 1, 2, 1, 0, 3;
  EXPECT_EQ(selfCrossings(fold).size(), 1U);
  fold.points(3, 1) = -0.7;
  EXPECT_TRUE(selfCrossings(fold).empty());
  Matrix3d touching;  // a corner on the other's face
  touching << 0.2, 0.2, 0, 0.2, 0.2, 1, 0.4, 0.2, 1;
  EXPECT_EQ(selfCrossings(pair(a, touching)).size(), 1U);
}

}  // namespace
}  // namespace falciform
