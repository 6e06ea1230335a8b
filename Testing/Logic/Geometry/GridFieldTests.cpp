#include "Logic/Geometry/GridField.h"

#include <gtest/gtest.h>

#include "Logic/Geometry/Crossings.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Remesh.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/Geometry/TriangleTree.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using test::sphere;

double farthest(const Surface& from, const Surface& to) {
  const TriangleTree tree(to);
  double most = 0;
  for (Index i = 0; i < from.size(); ++i)
    most = std::max(most, tree.closest(from.points.row(i).transpose()).distance);
  return most;
}

TEST(GridField, OfABallIsTheDistanceToIt) {
  const GridField field = signedDistanceField(sphere(20, 5), 1.3, 6);
  for (int z = 0; z < field.counts.z(); ++z)
    for (int y = 0; y < field.counts.y(); ++y)
      for (int x = 0; x < field.counts.x(); ++x) {
        const double wanted = std::clamp(field.place(x, y, z).norm() - 20, -6.0, 6.0);
        // 0.02 mm: how far the facets of an edge of 0.7 mm lie inside the ball.
        ASSERT_NEAR(field.values[field.index(x, y, z)], wanted, 0.02);
      }
}

TEST(LevelSurface, IsAClosedSurfaceWithoutCrossingsAtTheLevel) {
  const Surface body = test::lumpyBody(4);
  for (const double level : {-3.0, 0.0, 4.0}) {
    const Surface made = levelSurface(signedDistanceField(body, 3, 10), level);
    const TopologyReport topology = inspectTopology(made);
    EXPECT_TRUE(topology.closedManifold()) << describeTopology(topology);
    EXPECT_TRUE(selfCrossings(made).empty());
    EXPECT_GT(signedVolume(made), 0);
    const TriangleTree tree(body);
    for (Index i = 0; i < made.size(); ++i) {
      const ClosestPlace place = tree.closest(made.points.row(i).transpose());
      EXPECT_NEAR(place.side * place.distance, level, 0.75);  // mm: a quarter of a cell, at creases
    }
  }
}

TEST(RoundedSurface, IsTheSurfaceWhereItIsWide) {
  const Surface ball = sphere(30, 5);
  const Surface rounded = roundedSurface(ball, 2, 2, 1.5);
  EXPECT_TRUE(inspectTopology(rounded).closedManifold());
  EXPECT_LT(farthest(rounded, ball), 0.2);  // mm: linear between corners of 1.5 mm on a radius of 30
  EXPECT_NEAR(signedVolume(rounded), signedVolume(ball), 0.01 * signedVolume(ball));
}

TEST(RoundedSurface, ClosesATunnelNarrowerThanTheBallAndLeavesAWideOne) {
  const Surface ring = test::torus(20, 14, 80, 60);  // its hole is 12 mm wide
  EXPECT_EQ(inspectTopology(roundedSurface(ring, 3, 0, 1.5)).eulerCharacteristic, 0);
  const Surface closed = roundedSurface(ring, 8, 0, 1.5);
  EXPECT_EQ(inspectTopology(closed).eulerCharacteristic, 2);
  EXPECT_LT(farthest(closed, ring), 8);  // mm: the ball's radius
}

TEST(RoundedSurface, JoinsSheetsThatOverlap) {
  // A ball of which one side is pushed through the other: the part outside is turned inside out.
  Surface ball = sphere(30, 5);
  for (Index i = 0; i < ball.size(); ++i)
    if (ball.points(i, 2) > 20) ball.points(i, 2) -= 8 * (ball.points(i, 2) - 20);
  ASSERT_FALSE(selfCrossings(ball).empty());
  const Surface rounded = roundedSurface(ball, 1, 1, 1.5);
  EXPECT_TRUE(inspectTopology(rounded).closedManifold());
  EXPECT_TRUE(selfCrossings(rounded).empty());
  EXPECT_LT(farthest(rounded, ball), 2);  // mm: a ball and a cell
}

TEST(RemeshIsotropic, FollowsAnEdgeLengthThatVaries) {
  const auto edgeAt = [](const Vector3d& x) {
    return std::clamp(2 + 0.3 * (x - Vector3d(0, 0, 40)).norm(), 2.0, 8.0);
  };
  const Surface made = remeshIsotropic(sphere(40, 5), edgeAt, 2);
  EXPECT_TRUE(inspectTopology(made).closedManifold());
  double fine = 0, coarse = 0;
  Index fines = 0, coarses = 0;
  for (Index t = 0; t < made.triangles.rows(); ++t)
    for (Index k = 0; k < 3; ++k) {
      const Eigen::RowVector3d a = made.points.row(made.triangles(t, k)),
                               b = made.points.row(made.triangles(t, (k + 1) % 3));
      const double length = (a - b).norm() / edgeAt((a + b).transpose() / 2);
      (a.z() > 35 ? fine : coarse) += length;
      ++(a.z() > 35 ? fines : coarses);
    }
  // In edge lengths aimed at: the bounds of splits and collapses are 4/3 and 4/5.
  EXPECT_NEAR(fine / static_cast<double>(fines), 1, 0.2);
  EXPECT_NEAR(coarse / static_cast<double>(coarses), 1, 0.2);
}

}  // namespace
}  // namespace falciform
