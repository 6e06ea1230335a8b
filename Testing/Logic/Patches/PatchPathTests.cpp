#include "Logic/Patches/PatchPath.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>

#include "Logic/Patches/CrestStrength.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

SurfacePlace nearest(const TriangleTree& tree, const Vector3d& point) {
  const ClosestPlace place = tree.closest(point);
  Index corner = 0;
  place.barycentric.maxCoeff(&corner);
  return {place.triangle, tree.vertexOf(place.triangle, static_cast<int>(corner)), place.point};
}

std::vector<SurfacePlace> pathOn(const Surface& surface, const Vector3d& from, const Vector3d& to,
                                 const VectorXd& cost = {}) {
  const TriangleTree tree(surface);
  return shortestPath(BrushSurface(surface), &tree, nearest(tree, from), nearest(tree, to), cost);
}

/// Length of the cheapest way over edges from vertex to vertex, by Bellman and Ford's sweeps over all edges.
double edgeLength(const Surface& surface, int from, int to, const VectorXd& cost = {}) {
  std::vector<double> length(static_cast<std::size_t>(surface.size()), 1e18);
  length[static_cast<std::size_t>(from)] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (Index t = 0; t < surface.triangles.rows(); ++t)
      for (int k = 0; k < 3; ++k)
        for (const int back : {0, 1}) {
          const int a = surface.triangles(t, (k + back) % 3), b = surface.triangles(t, (k + 1 - back) % 3);
          const double weight = cost.size() > 0 ? 0.5 * (cost[a] + cost[b]) : 1;
          const double through = length[static_cast<std::size_t>(a)] +
                                 weight * (surface.points.row(a) - surface.points.row(b)).norm();
          if (through < length[static_cast<std::size_t>(b)] - 1e-12) {
            length[static_cast<std::size_t>(b)] = through;
            changed = true;
          }
        }
  }
  return length[static_cast<std::size_t>(to)];
}

TEST(PatchPath, IsTheStraightLineOnAPlaneHoweverTheMeshIsCut) {
  const Surface plane = test::grid(60, 40);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(2, 58);
  for (int trial = 0; trial < 10; ++trial) {
    const Vector3d from(place(random), place(random), 0), to(place(random), place(random), 0);
    const auto path = pathOn(plane, from, to);
    ASSERT_GE(path.size(), 2U);
    EXPECT_LT((path.front().point - from).norm(), 1e-9) << "mm";
    EXPECT_LT((path.back().point - to).norm(), 1e-9) << "mm";
    EXPECT_NEAR(lengthOf(path), (to - from).norm(), 1e-3 * (to - from).norm());
    const Vector3d along = (to - from).normalized();
    for (const SurfacePlace& knot : path)  // mm; edges are 1.5 mm, a way over them strays by several
      EXPECT_LT((knot.point - from).cross(along).norm(), 0.1);
  }
}

TEST(PatchPath, IsAGreatCircleOnASphere) {
  const Surface ball = test::sphere(50, 5);
  const Vector3d from = 50 * Vector3d(1, 0.2, 0.1).normalized(),
                 to = 50 * Vector3d(-0.3, 1, 0.6).normalized();
  const auto path = pathOn(ball, from, to);
  const double truth = 50 * std::acos(from.dot(to) / 2500);
  EXPECT_NEAR(lengthOf(path), truth, 2e-3 * truth);  // the mesh itself is shorter than the sphere by that
  const Vector3d pole = from.cross(to).normalized();
  for (const SurfacePlace& knot : path) EXPECT_LT(std::abs(knot.point.dot(pole)), 0.3) << "mm off the circle";
}

TEST(PatchPath, IsNeverLongerThanTheBestWayOverEdgesNorShorterThanTheDistance) {
  const Surface body = test::lumpyBody(4);
  std::mt19937 random(11);
  for (int trial = 0; trial < 8; ++trial) {
    const int a = static_cast<int>(random() % static_cast<unsigned>(body.size()));
    const int b = static_cast<int>(random() % static_cast<unsigned>(body.size()));
    const Vector3d from = body.points.row(a), to = body.points.row(b);
    if (a == b) continue;
    const auto path = pathOn(body, from, to);
    ASSERT_FALSE(path.empty());
    const double overEdges = edgeLength(body, a, b);
    EXPECT_LE(lengthOf(path), overEdges * (1 + 1e-6));
    EXPECT_GE(lengthOf(path), (to - from).norm() * (1 - 1e-9));
    const TriangleTree tree(body);
    for (std::size_t i = 1; i < path.size(); ++i) {
      EXPECT_LT(tree.closest(path[i].point).distance, 1e-6) << "mm: on the surface";
      EXPECT_LT((path[i].point - path[i - 1].point).norm(), 1.5) << "mm: without a leap";
    }
  }
}

TEST(PatchPath, WithCostsItIsTheCheapestWayOverEdges) {
  const Surface body = test::lumpyBody(4);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> price(0.05, 1);
  VectorXd cost(body.size());
  for (double& value : cost) value = price(random);
  const int a = 17, b = static_cast<int>(body.size()) - 5;
  const auto path = pathOn(body, body.points.row(a), body.points.row(b), cost);
  // The places of the answer stand half a mm apart on the edges of the way; what lies between two vertices
  // costs what lies between their costs.
  const TriangleTree tree(body);
  double paid = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vector3d middle = 0.5 * (path[i].point + path[i - 1].point);
    const ClosestPlace place = tree.closest(middle);
    double here = 0;
    for (int k = 0; k < 3; ++k) here += place.barycentric[k] * cost[tree.vertexOf(place.triangle, k)];
    paid += here * (path[i].point - path[i - 1].point).norm();
  }
  const double best = edgeLength(body, a, b, cost);
  EXPECT_NEAR(paid, best, 0.03 * best);  // corners are cut where a step passes a vertex
}

TEST(PatchPath, SnappedToARidgeItRunsAlongTheEdgeOfAWedge) {
  // A roof with its ridge along y at x = 20, and a straight way beside it.
  Surface roof = test::grid(40, 40);
  for (Index i = 0; i < roof.size(); ++i) roof.points(i, 2) = 6 - std::hypot(2.0, roof.points(i, 0) - 20);
  const Vector3d from(14, 4, 0), to(14, 36, 0);
  const auto straight = pathOn(roof, from, to);
  const auto snapped = pathOn(roof, from, to, crestCost(roof, CrestKind::Ridge, 3));
  const auto groove = pathOn(roof, from, to, crestCost(roof, CrestKind::Valley, 3));
  const auto middle = [](const auto& path) { return path[path.size() / 2].point.x(); };
  EXPECT_LT(middle(straight), 15.5);
  EXPECT_NEAR(middle(snapped), 20, 1.1) << "on the ridge, to a vertex";
  EXPECT_LT(middle(groove), 15.5) << "a ridge is no groove";
}

TEST(PatchPath, OnACloudItGoesFromNeighbourToNeighbourAroundAGap) {
  // A sheet of points with a slit: links are 3 mm, the slit 8 mm wide.
  Surface sheet = test::grid(40, 40);
  std::vector<int> keep;
  for (Index i = 0; i < sheet.size(); ++i)
    if (std::abs(sheet.points(i, 0) - 20) > 4 || sheet.points(i, 1) > 30) keep.push_back(static_cast<int>(i));
  Surface cloud = subset(sheet, keep);
  cloud.triangles.resize(0, 3);
  const BrushSurface surface(cloud);
  const auto place = [&](const Vector3d& point) {
    Index at = 0;
    (cloud.points.rowwise() - point.transpose()).rowwise().norm().minCoeff(&at);
    return SurfacePlace{-1, static_cast<int>(at), cloud.points.row(at)};
  };
  const auto path = shortestPath(surface, nullptr, place({10, 5, 0}), place({30, 5, 0}));
  ASSERT_FALSE(path.empty());
  for (std::size_t i = 1; i < path.size(); ++i)
    EXPECT_LE((path[i].point - path[i - 1].point).norm(), 3 + 1e-9);
  EXPECT_GT(lengthOf(path), 2 * 25.0) << "up past the slit's end and down again";
  EXPECT_LT(lengthOf(path), 1.1 * 2 * std::hypot(26.0, 6.0) + 9);
}

TEST(PatchPath, BetweenPiecesThereIsNone) {
  Surface two = test::sphere(20, 3);
  const Surface far = test::sphere(20, 3, {100, 0, 0});
  const Index n = two.size(), m = two.triangles.rows();
  two.points.conservativeResize(2 * n, 3);
  two.points.bottomRows(n) = far.points;
  two.triangles.conservativeResize(2 * m, 3);
  two.triangles.bottomRows(m) = far.triangles.array() + static_cast<int>(n);
  EXPECT_TRUE(pathOn(two, {20, 0, 0}, {120, 0, 0}).empty());
}

TEST(PatchPath, ItsWidthIsThatOfACapsule) {
  const Surface plane = test::grid(40, 80);
  const Vector3d from(8.3, 9.1, 0), to(31.7, 24.4, 0), along = to - from;
  const BrushSurface surface(plane);
  const auto path = pathOn(plane, from, to);
  const std::vector<int> ids = pointsAlong(surface, path, 3);
  const std::set<int> set(ids.begin(), ids.end());
  for (Index i = 0; i < plane.size(); ++i) {
    const Vector3d p = plane.points.row(i).transpose();
    const double t = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double far = (p - from - t * along).norm();
    // mm: half a percent of the width between two discs, and what the line itself strays.
    if (far < 2.9) {
      EXPECT_TRUE(set.count(static_cast<int>(i))) << far;
    }
    if (far > 3.1) {
      EXPECT_FALSE(set.count(static_cast<int>(i))) << far;
    }
  }
}

}  // namespace
}  // namespace falciform
