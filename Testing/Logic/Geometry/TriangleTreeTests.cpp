#include "Logic/Geometry/TriangleTree.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using test::randomMotion;

/// Closest point by another road than the tree's: the plane's foot if inside, else the best of three clamped
/// edges.
double bruteDistance(const Surface& s, Index t, const Vector3d& q) {
  std::array<Vector3d, 3> p;
  for (int k = 0; k < 3; ++k) p[static_cast<std::size_t>(k)] = s.points.row(s.triangles(t, k));
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3d from = p[k], along = p[(k + 1) % 3] - from;
    const double length2 = along.squaredNorm();
    const double at = length2 > 0 ? std::clamp((q - from).dot(along) / length2, 0.0, 1.0) : 0.0;
    best = std::min(best, (q - from - at * along).norm());
  }
  const Vector3d n = (p[1] - p[0]).cross(p[2] - p[0]);
  if (!(n.norm() > 1e-9)) return best;  // mm^2: as good as its edges
  const Vector3d unit = n.normalized(), foot = q - (q - p[0]).dot(unit) * unit;
  for (std::size_t k = 0; k < 3; ++k)
    if ((p[(k + 1) % 3] - p[k]).cross(foot - p[k]).dot(unit) < 0) return best;
  return std::min(best, std::abs((q - p[0]).dot(unit)));
}

double bruteDistance(const Surface& s, const Vector3d& q) {
  double best = std::numeric_limits<double>::infinity();
  for (Index t = 0; t < s.triangles.rows(); ++t) best = std::min(best, bruteDistance(s, t, q));
  return best;
}

/// Triangles of all sizes in a cube of 100 mm, a third of them needles, lines or points.
Surface triangleSoup(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-50, 50), size(0.1, 20), unit(-1, 1);
  Surface s;
  s.points.resize(3 * count, 3);
  s.triangles.resize(count, 3);
  for (int t = 0; t < count; ++t) {
    const Vector3d a(place(random), place(random), place(random));
    const double r = size(random);
    const Vector3d u(unit(random), unit(random), unit(random)), v(unit(random), unit(random), unit(random));
    Vector3d b = a + r * u, c = a + r * v;
    if (t % 12 == 0) c = a + 0.4 * (b - a);                 // in line
    if (t % 12 == 1) c = b;                                 // two corners in one
    if (t % 12 == 2) b = c = a;                             // a point
    if (t % 12 == 3) c = a + 0.4 * (b - a) + 1e-7 * r * v;  // a needle
    s.points.row(3 * t) = a;
    s.points.row(3 * t + 1) = b;
    s.points.row(3 * t + 2) = c;
    s.triangles.row(t) << 3 * t, 3 * t + 1, 3 * t + 2;
  }
  return s;
}

Vector3d randomPoint(std::mt19937& random, double halfEdge) {
  std::uniform_real_distribution<double> place(-halfEdge, halfEdge);
  const double x = place(random), y = place(random);
  return {x, y, place(random)};
}

TEST(TriangleTree, FindsTheDistanceThatBruteForceFindsDegenerateTrianglesIncluded) {
  for (const int count : {1, 2, 5, 17, 400}) {
    const Surface soup = triangleSoup(count, 7);
    const TriangleTree tree(soup);
    std::mt19937 random(11);
    for (int i = 0; i < 400; ++i) {
      const Vector3d q = randomPoint(random, i % 2 == 0 ? 60 : 600);
      const ClosestPlace found = tree.closest(q);
      // 1e-9 mm: rounding of coordinates of 600 mm in two different formulas.
      ASSERT_NEAR(found.distance, bruteDistance(soup, q), 1e-9)
          << "query " << i << " of " << count << " triangles";
      ASSERT_NEAR(found.distance, (q - found.point).norm(), 1e-12);
      Vector3d rebuilt = Vector3d::Zero();
      for (int k = 0; k < 3; ++k)
        rebuilt += found.barycentric[k] * Vector3d(soup.points.row(tree.vertexOf(found.triangle, k)));
      ASSERT_NEAR((rebuilt - found.point).norm(), 0, 1e-9);
      ASSERT_GE(found.barycentric.minCoeff(), -1e-9);
      ASSERT_TRUE(found.side == 1 || found.side == -1);
    }
  }
}

TEST(TriangleTree, GivesTheLowestIndexOfCopiesOfATriangle) {
  Surface s = test::box({10, 10, 10});
  const Index once = s.triangles.rows();
  Triangles thrice(3 * once, 3);
  thrice << s.triangles, s.triangles, s.triangles;
  s.triangles = thrice;
  const TriangleTree tree(s);
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    const Vector3d q = randomPoint(random, 15);
    EXPECT_LT(tree.closest(q).triangle, once);
    if (const auto hit = tree.cast(q, Vector3d(5, 5, 5) - q)) {
      EXPECT_LT(hit->triangle, once);
    }
  }
}

TEST(TriangleTree, FindsNothingBeyondTheBoundAndTheSameWithinIt) {
  const Surface s = test::sphere(30, 3);
  const TriangleTree tree(s);
  std::mt19937 random(5);
  for (int i = 0; i < 300; ++i) {
    const Vector3d q = randomPoint(random, 60);
    const ClosestPlace free = tree.closest(q), bounded = tree.closest(q, 10);
    EXPECT_EQ(bounded.triangle, free.distance <= 10 ? free.triangle : -1);
  }
}

TEST(TriangleTree, WorksFarFromTheOriginAndForFarQueries) {
  Surface s = test::sphere(30, 3);
  const Vector3d away(1e5, -2e5, 3e5);  // mm: a frame whose origin is hundreds of metres off
  s.points.rowwise() += away.transpose();
  const TriangleTree tree(s);
  std::mt19937 random(9);
  for (int i = 0; i < 100; ++i) {
    const Vector3d q = randomPoint(random, i % 3 == 0 ? 1e6 : 45) + away;
    EXPECT_NEAR(tree.closest(q).distance, bruteDistance(s, q),
                1e-8);  // mm: 1e-10 of rounding in 1e6 mm, squared sums
  }
  EXPECT_GE(tree.closest({1e25, 0, 0}).triangle, 0);
  EXPECT_TRUE(tree.cast(away - Vector3d(0, 0, 1e6), Vector3d(0.01, 0.02, 1)).has_value() ==
              false);  // passes 10 m beside it
  EXPECT_NEAR(tree.cast(away - Vector3d(0, 0, 1e6), {0, 0, 1})->distance, 1e6 - 30,
              0.5);  // mm: facets of the sphere
}

TEST(TriangleTree, KnowsTheSideNearFacesEdgesAndCornersOfABox) {
  const Surface s = test::box({20, 10, 5});
  const TriangleTree tree(s);
  const Eigen::AlignedBox3d inside(Vector3d(0, 0, 0), Vector3d(20, 10, 5));
  std::mt19937 random(13);
  for (int i = 0; i < 5000; ++i) {
    const Vector3d q = randomPoint(random, 12) + Vector3d(10, 5, 2.5);
    EXPECT_EQ(tree.closest(q).side, inside.contains(q) ? -1 : 1) << q.transpose();
    EXPECT_EQ(tree.closestAnySide(q).point, tree.closest(q).point);
    EXPECT_EQ(tree.closestAnySide(q).side, 1);
  }
}

TEST(TriangleTree, KnowsTheSideOfATurnedTorusAndOfOneStoredTriangleByTriangle) {
  Surface s = test::torus(30, 10, 48, 24);
  const Isometry3d motion = randomMotion(21);
  s.points = transformed(s.points, motion);
  Surface loose;  // every triangle with corners of its own
  loose.points.resize(3 * s.triangles.rows(), 3);
  loose.triangles.resize(s.triangles.rows(), 3);
  for (Index t = 0; t < s.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      loose.points.row(3 * t + k) = s.points.row(s.triangles(t, k));
      loose.triangles(t, k) = static_cast<int>(3 * t + k);
    }
  const TriangleTree tree(s), looseTree(loose);
  std::mt19937 random(17);
  int tested = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vector3d q = randomPoint(random, 45);
    const double signedDistance = std::hypot(std::hypot(q.x(), q.y()) - 30, q.z()) - 10;
    if (std::abs(signedDistance) < 0.3) continue;  // mm: facets lie up to 0.15 mm off the true torus
    ++tested;
    EXPECT_EQ(tree.closest(motion * q).side, signedDistance > 0 ? 1 : -1);
    EXPECT_EQ(looseTree.closest(motion * q).side, signedDistance > 0 ? 1 : -1);
  }
  EXPECT_GT(tested, 3000);
}

TEST(TriangleTree, KnowsTheSideOfASharpSpikeWhereFaceNormalsMislead) {
  // A needle-sharp pyramid: outside its tip, single faces' normals disagree (Baerentzen and Aanaes's
  // example).
  Surface s;
  s.points.resize(4, 3);
  s.points << -1, -1, 0, 1, -1, 0, 0, 1, 0, 8, 0, 3;
  s.triangles.resize(4, 3);
  s.triangles << 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3;
  const TriangleTree tree(s);
  std::mt19937 random(19);
  for (int i = 0; i < 2000; ++i) {
    const Vector3d q = randomPoint(random, 1.5) + Vector3d(8, 0, 3);
    bool inside = true;  // of a convex body: behind all faces
    for (int t = 0; t < 4; ++t)
      inside = inside && (q - Vector3d(s.points.row(s.triangles(t, 0)))).dot(tree.triangleNormal(t)) < 0;
    EXPECT_EQ(tree.closest(q).side, inside ? -1 : 1) << q.transpose();
  }
}

TEST(TriangleTree, AnswersTheSameOnOneThreadAndOnMany) {
  const Surface s = test::lumpyBody(4);
  const TriangleTree tree(s);
  const auto ask = [&](int threadCount) {
    setThreads(threadCount);
    std::vector<std::array<double, 5>> answers(2000);
    forEachChunk(2000, 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        std::mt19937 random(static_cast<unsigned>(i));
        const ClosestPlace p = tree.closest(randomPoint(random, 150));
        answers[i] = {p.point.x(), p.point.y(), p.point.z(), p.side, static_cast<double>(p.triangle)};
      }
    });
    setThreads(0);
    return answers;
  };
  EXPECT_EQ(ask(1), ask(4));
}

TEST(TriangleTree, RefusesACloud) {
  Surface cloud;
  cloud.points = Points::Random(10, 3);
  EXPECT_THROW(TriangleTree{cloud}, InputError);
}

}  // namespace
}  // namespace falciform
