#include "Logic/Geometry/Geodesics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "Logic/Geometry/TriangleTree.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

std::vector<GeodesicPoint> around(const Surface& s, const Vector3d& seed, double radius,
                                  const std::vector<char>& allowed = {}) {
  const ClosestPlace place = TriangleTree(s).closest(seed);
  return withinGeodesicRadius(s, trianglesOfVertices(s.triangles, s.size()), place.triangle, place.point,
                              radius, allowed);
}

TEST(Geodesics, AreStraightLinesOnAPlane) {
  Surface s = test::grid(40, 40);
  const Vector3d seed(17.3, 21.9, 0);
  const std::vector<GeodesicPoint> found = around(s, seed, 12);
  std::set<int> ids;
  for (const GeodesicPoint& p : found) {
    const double straight = (Vector3d(s.points.row(p.vertex)) - seed).norm();
    EXPECT_NEAR(p.distance, straight, 1e-9);  // mm: right triangles, so every line is unfolded exactly
    ids.insert(p.vertex);
  }
  for (Index i = 0; i < s.size(); ++i)
    EXPECT_EQ(ids.count(static_cast<int>(i)) == 1, (Vector3d(s.points.row(i)) - seed).norm() <= 12) << i;
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end(),
                             [](const auto& a, const auto& b) { return a.distance < b.distance; }));
}

TEST(Geodesics, StayWithinOnePercentOnAShearedPlaneOfObtuseTriangles) {
  Surface s = test::grid(40, 40);
  s.points.col(0) += 0.8 * s.points.col(1);
  const Vector3d seed = s.points.row(20 * 41 + 20);
  for (const GeodesicPoint& p : around(s, seed, 10)) {
    const double straight = (Vector3d(s.points.row(p.vertex)) - seed).norm();
    EXPECT_GE(p.distance, straight - 1e-9);
    EXPECT_LE(p.distance,
              1.01 * straight + 1e-9);  // 1 %: obtuse angles of 130 deg cost a detour now and then
  }
}

TEST(Geodesics, FollowGreatCirclesOnASphereAndImproveWithTheMesh) {
  const double radius = 50;
  double worstBefore = 1;
  for (const int subdivisions : {3, 4, 5}) {
    const Surface s = test::sphere(radius, subdivisions);
    const Vector3d seed = s.points.row(0);
    double worst = 0;
    for (const GeodesicPoint& p : around(s, seed, 60)) {
      if (p.distance < 15) continue;  // mm: below a few edges the relative error says little
      const double arc =
          radius * std::acos(std::clamp(seed.normalized().dot(Vector3d(s.points.row(p.vertex)).normalized()),
                                        -1.0, 1.0));
      worst = std::max(worst, std::abs(p.distance / arc - 1));
    }
    EXPECT_LT(worst, worstBefore) << subdivisions;
    worstBefore = worst;
  }
  EXPECT_LT(worstBefore, 0.01);  // 1 % at 1.6 mm edges
}

TEST(Geodesics, DoNotJumpToASheetCloseBy) {
  Surface s = test::grid(20, 20);
  const Index n = s.size(), m = s.triangles.rows();
  Surface two = s;
  two.points.resize(2 * n, 3);
  two.points << s.points, s.points;
  two.points.bottomRows(n).col(2).setConstant(0.5);  // mm above
  two.triangles.resize(2 * m, 3);
  two.triangles << s.triangles, (s.triangles.array() + static_cast<int>(n)).matrix();
  const std::vector<GeodesicPoint> found = around(two, {10, 10, 0}, 6);
  EXPECT_GT(found.size(), 90U);
  for (const GeodesicPoint& p : found) EXPECT_LT(p.vertex, n);
}

TEST(Geodesics, GoAroundWhatIsNotAllowed) {
  // A wall at x = 10 with a gap at y >= 16: the way is a corner of two straight lines.
  Surface s = test::grid(20, 20);
  std::vector<char> allowed(static_cast<std::size_t>(s.size()), 1);
  int behind = -1;
  for (Index i = 0; i < s.size(); ++i) {
    if (std::abs(s.points(i, 0) - 10) < 0.1 && s.points(i, 1) < 15.5)
      allowed[static_cast<std::size_t>(i)] = 0;
    if ((Vector3d(s.points.row(i)) - Vector3d(14, 10, 0)).norm() < 0.1) behind = static_cast<int>(i);
  }
  bool seen = false;
  for (const GeodesicPoint& p : around(s, {6, 10, 0}, 30, allowed)) {
    EXPECT_TRUE(allowed[static_cast<std::size_t>(p.vertex)]);
    if (p.vertex != behind) continue;
    seen = true;
    EXPECT_GE(p.distance, 2 * std::hypot(4, 6) - 1e-9);
    EXPECT_LE(p.distance, 2 * std::hypot(4, 6) + 1.5);  // mm: round the corner it steps over cells of 1 mm
  }
  EXPECT_TRUE(seen);
}

TEST(Geodesics, AreEmptyForNoRadiusAndForATriangleThatIsNotThere) {
  const Surface s = test::grid(10, 10);
  const Adjacency triangles = trianglesOfVertices(s.triangles, s.size());
  EXPECT_TRUE(withinGeodesicRadius(s, triangles, 0, {0, 0, 0}, 0).empty());
  EXPECT_TRUE(withinGeodesicRadius(s, triangles, -1, {0, 0, 0}, 5).empty());
  EXPECT_TRUE(withinGeodesicRadius(s, triangles, 200, {0, 0, 0}, 5).empty());
}

}  // namespace
}  // namespace falciform
