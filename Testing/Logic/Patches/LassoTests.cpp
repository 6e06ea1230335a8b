#include "Logic/Patches/Lasso.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "Logic/Geometry/Measures.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using Outline = Eigen::Matrix<double, Eigen::Dynamic, 2>;

Outline circle(double x, double y, double radius, int corners = 60) {
  Outline line(corners, 2);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    line.row(i) << x + radius * std::cos(angle), y + radius * std::sin(angle);
  }
  return line;
}

/// A viewer at `eye` on the z axis above, looking down; screen = x and y scaled by 1 / depth.
LassoView above(double height) {
  LassoView view;
  view.eye = {0, 0, height};
  view.screenFromSurface << 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -1, height;
  return view;
}

std::vector<int> chosen(const Surface& surface, const LassoView& view, const Outline& line) {
  if (surface.triangles.rows() == 0) return pointsInLasso(surface, surface.normals, nullptr, view, line);
  const TriangleTree tree(surface);
  return pointsInLasso(surface, vertexNormals(surface), &tree, view, line);
}

TEST(Lasso, TakesWhatLiesInsideTheOutlineOnScreen) {
  Surface plane = test::grid(40, 40);
  plane.points.rowwise() -= Eigen::RowVector3d(20, 20, 0);
  const std::vector<int> ids = chosen(plane, above(100), circle(0.03, 0.02, 0.08));
  std::vector<int> expected;  // screen = mm / 100
  for (Index i = 0; i < plane.size(); ++i)
    if ((plane.points.row(i).head(2) - Eigen::RowVector2d(3, 2)).norm() < 8 * std::cos(std::numbers::pi / 60))
      expected.push_back(static_cast<int>(i));
  EXPECT_THAT(ids, testing::IsSupersetOf(expected));
  for (const int id : ids) EXPECT_LE((plane.points.row(id).head(2) - Eigen::RowVector2d(3, 2)).norm(), 8.0);
}

TEST(Lasso, TakesNeitherTheFarSideNorWhatIsHidden) {
  // A ball below a ball: of both the lasso takes what the viewer sees.
  Surface two = test::sphere(20, 4);
  const Surface below = test::sphere(25, 4, {0, 0, -60});
  const Index n = two.size(), m = two.triangles.rows();
  two.points.conservativeResize(n + below.size(), 3);
  two.points.bottomRows(below.size()) = below.points;
  two.triangles.conservativeResize(m + below.triangles.rows(), 3);
  two.triangles.bottomRows(below.triangles.rows()) = below.triangles.array() + static_cast<int>(n);
  LassoView view = above(0);
  view.parallel = true;
  view.eye = {0, 0, 1};
  view.screenFromSurface.row(3) << 0, 0, 0, 1;
  const std::vector<int> ids = chosen(two, view, circle(0, 0, 40));
  const std::set<int> set(ids.begin(), ids.end());
  for (Index i = 0; i < two.size(); ++i) {
    const Vector3d p = two.points.row(i).transpose();
    const double fromAxis = p.head(2).norm();
    const bool upper = i < n;
    const double up = upper ? p.z() : p.z() + 60;
    if (std::abs(up) < 2 || std::abs(fromAxis - 20) < 0.5) continue;  // mm: on the rim, by the mesh's facets
    const bool seen = up > 0 && (upper || fromAxis > 20);
    EXPECT_EQ(set.count(static_cast<int>(i)) == 1, seen) << p.transpose();
  }
}

TEST(Lasso, OfACloudTakesPointsThatFaceTheViewer) {
  Surface cloud = test::sphere(20, 4);
  cloud.normals = vertexNormals(cloud);
  cloud.triangles.resize(0, 3);
  const std::vector<int> facing = chosen(cloud, above(200), circle(0, 0, 1));
  ASSERT_FALSE(facing.empty());
  for (const int id : facing) EXPECT_GT(cloud.points(id, 2), 1) << "mm: a viewer at 200 sees less than half";
  cloud.normals.resize(0, 3);
  EXPECT_EQ(static_cast<Index>(chosen(cloud, above(200), circle(0, 0, 1)).size()), cloud.size());
}

TEST(Lasso, IsEmptyBehindTheViewerAndWithoutAnArea) {
  Surface plane = test::grid(10, 10);
  EXPECT_TRUE(chosen(plane, above(-50), circle(0, 0, 100)).empty());
  EXPECT_TRUE(chosen(plane, above(50), circle(0, 0, 100, 2)).empty());
  EXPECT_TRUE(chosen(plane, above(50), Outline(0, 2)).empty());
}

TEST(Lasso, AnOutlineThatCrossesItselfCountsByTheEvenOddRule) {
  Surface plane = test::grid(20, 20);
  plane.points.rowwise() -= Eigen::RowVector3d(10, 10, 0);
  Outline twice(8, 2);  // the same square walked twice
  twice << -.05, -.05, .05, -.05, .05, .05, -.05, .05, -.05, -.05, .05, -.05, .05, .05, -.05, .05;
  EXPECT_TRUE(chosen(plane, above(100), twice).empty());
}

}  // namespace
}  // namespace falciform
