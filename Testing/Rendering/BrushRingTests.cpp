#include "Widgets/Rendering/BrushRing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "Testing/Support/SmallSurfaces.h"

namespace falciform {

TEST(BrushRing, IsACircleOnAPlane) {
  const TriangleTree tree(test::grid(100, 20));
  const auto hit = tree.cast({51, 47, 10}, {0, 0, -1});
  ASSERT_TRUE(hit);
  const Points ring = geodesicRing(tree, hit->triangle, hit->point, 12);
  ASSERT_EQ(ring.rows(), 48);
  // Exact but for rounding: mm.
  for (Index i = 0; i < ring.rows(); ++i)
    EXPECT_NEAR((ring.row(i).transpose() - Vector3d(51, 47, 0)).norm(), 12, 1e-9);
}

TEST(BrushRing, KeepsItsDistanceAlongASphere) {
  const double radius = 50, brush = 20;
  const TriangleTree tree(test::sphere(radius, 5));
  const auto hit = tree.cast({3, 5, 200}, {0, 0, -1});
  ASSERT_TRUE(hit);
  const Points ring = geodesicRing(tree, hit->triangle, hit->point, brush);
  for (Index i = 0; i < ring.rows(); ++i) {
    const double angle = std::acos(ring.row(i).transpose().normalized().dot(hit->point.normalized()));
    // Eight straight steps of 2.5 mm on a radius of 50 mm each fall short by (2.5/50)^2/3 of their length:
    // 0.02 mm in all, and as much again for the facets.
    EXPECT_NEAR(radius * angle, brush, 0.1);
  }
}

TEST(BrushRing, StaysOnAnOpenSurface) {
  const TriangleTree tree(test::grid(100, 20));
  const auto hit = tree.cast({4, 50, 10}, {0, 0, -1});
  ASSERT_TRUE(hit);
  const Points ring = geodesicRing(tree, hit->triangle, hit->point, 12);
  EXPECT_GE(ring.col(0).minCoeff(), -1e-12);
  EXPECT_NEAR(ring.col(0).maxCoeff(), 16, 0.1);
}

TEST(BrushRing, FlatRingLiesAcrossTheView) {
  const Vector3d centre(1, 2, 3), view = Vector3d(1, -2, 0.5).normalized();
  const Points ring = flatRing(centre, view, 7);
  for (Index i = 0; i < ring.rows(); ++i) {
    EXPECT_NEAR((ring.row(i).transpose() - centre).norm(), 7, 1e-12);
    EXPECT_NEAR((ring.row(i).transpose() - centre).dot(view), 0, 1e-12);
  }
}

}  // namespace falciform
