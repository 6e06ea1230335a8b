#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "Logic/Geometry/TriangleTree.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

Vector3d gaussian(std::mt19937& random) {
  std::normal_distribution<double> n;
  const double x = n(random), y = n(random);
  return {x, y, n(random)};
}

/// First crossing by signs of volumes: the ray passes a triangle if it turns the same way round all three
/// sides.
double bruteCast(const Surface& s, const Vector3d& origin, const Vector3d& unit) {
  double best = std::numeric_limits<double>::infinity();
  for (Index t = 0; t < s.triangles.rows(); ++t) {
    const Vector3d a = s.points.row(s.triangles(t, 0)), b = s.points.row(s.triangles(t, 1)),
                   c = s.points.row(s.triangles(t, 2));
    const double x = (a - origin).cross(b - origin).dot(unit), y = (b - origin).cross(c - origin).dot(unit),
                 z = (c - origin).cross(a - origin).dot(unit);
    if (!((x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0))) continue;
    const Vector3d n = (b - a).cross(c - a);
    const double distance = (a - origin).dot(n) / unit.dot(n);
    if (distance >= 0) best = std::min(best, distance);
  }
  return best;
}

TEST(TriangleTreeRays, HitWhatBruteForceHits) {
  const Surface s = test::torus(30, 10, 40, 20);
  const TriangleTree tree(s);
  std::mt19937 random(1);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector3d origin = (i % 2 == 0 ? 20 : 200) * gaussian(random);
    const Vector3d direction = i % 3 == 0 ? gaussian(random) : Vector3d(25 * gaussian(random) - origin);
    const auto hit = tree.cast(origin, direction);
    const double expected = bruteCast(s, origin, direction.normalized());
    ASSERT_EQ(hit.has_value(), std::isfinite(expected)) << i;
    if (!hit) continue;
    ++hits;
    ASSERT_NEAR(hit->distance, expected, 1e-8);  // mm: rounding at 600 mm over grazing incidence
    ASSERT_NEAR((origin + hit->distance * direction.normalized() - hit->point).norm(), 0, 1e-9);
  }
  EXPECT_GT(hits, 500);
}

TEST(TriangleTreeRays, PassNoEdgeOrVertexOfAClosedSurface) {
  const Surface s = test::sphere(30, 3);
  const TriangleTree tree(s);
  std::mt19937 random(2);
  for (Index t = 0; t < s.triangles.rows(); ++t) {
    const Vector3d from = 5 * gaussian(random) / 3;  // well inside
    const Vector3d a = s.points.row(s.triangles(t, 0)), b = s.points.row(s.triangles(t, 1));
    for (const Vector3d& target : {a, Vector3d(0.5 * (a + b)), Vector3d(0.3 * a + 0.7 * b)}) {
      const auto hit = tree.cast(from, target - from);
      ASSERT_TRUE(hit.has_value());
      ASSERT_NEAR((hit->point - target).norm(), 0, 1e-6);  // mm: a ray may end on either side of the edge
    }
  }
}

TEST(TriangleTreeRays, AlongTheAxesThroughAGridHitAtTheirHeight) {
  const TriangleTree tree(test::grid(10, 10));
  for (double x = 0; x <= 10; x += 0.5)
    for (double y = 0; y <= 10;
         y += 0.5) {  // half of them through edges and vertices, with zero direction components
      const auto down = tree.cast({x, y, 7}, {0, 0, -2});
      ASSERT_TRUE(down.has_value()) << x << " " << y;
      EXPECT_NEAR(down->distance, 7, 1e-12);
      EXPECT_FALSE(tree.cast({x, y, 7}, {0, 0, 1}).has_value());
    }
  EXPECT_FALSE(tree.cast({-1, 5, 1}, {1, 0, 0}).has_value());
}

TEST(TriangleTreeRays, FindNothingWithoutADirection) {
  const TriangleTree tree(test::sphere(30, 2));
  EXPECT_FALSE(tree.cast({0, 0, 0}, {0, 0, 0}).has_value());
  EXPECT_FALSE(tree.cast({NAN, 0, 0}, {0, 0, 1}).has_value());
}

}  // namespace
}  // namespace falciform
