#include "Logic/Geometry/ClosestPointGrid.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "Logic/Geometry/KdTree.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

std::vector<int> allRows(const Points& points) {
  std::vector<int> rows(static_cast<std::size_t>(points.rows()));
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

/// How much farther than the nearest point the answer lies, at most, for `count` queries within `spreadMm`.
double worstExcess(const Points& points, const ClosestPointGrid& grid, double spreadMm, int count) {
  const KdTree tree(points);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> draw(-spreadMm, spreadMm);
  double worst = 0;
  for (int k = 0; k < count; ++k) {
    const Vector3d query(draw(random), draw(random), draw(random));
    const Vector3d found = points.row(grid.closest(query.cast<float>()));
    worst = std::max(worst, (found - query).norm() - std::sqrt(tree.nearest(query).squaredDistance));
  }
  return worst;
}

TEST(ClosestPointGrid, AnswersAreWithinACellOfTheNearest) {
  const Surface body = test::lumpyBody(4);
  const ClosestPointGrid grid(body.points, allRows(body.points), 4, 40);
  // A query lies up to half a cell's diagonal (3.46 mm) from its centre, so the centre's nearest point is at
  // most that twice farther than the query's own; 0.1 mm for what two passes of the map leave.
  EXPECT_LT(worstExcess(body.points, grid, 90, 20000), 2 * 3.47 + 0.1);
}

TEST(ClosestPointGrid, FinerCellsAreNearerTheTruth) {
  const Surface body = test::lumpyBody(4);
  const double coarse =
      worstExcess(body.points, ClosestPointGrid(body.points, allRows(body.points), 8, 20), 80, 5000);
  const double fine =
      worstExcess(body.points, ClosestPointGrid(body.points, allRows(body.points), 2, 20), 80, 5000);
  EXPECT_LT(fine, 0.5 * coarse);
}

TEST(ClosestPointGrid, ServesOnlyTheRowsItWasGiven) {
  const Surface body = test::lumpyBody(4);
  const std::vector<int> rows = pointsOfPatch(body, patch::kFalciform);
  const ClosestPointGrid grid(body.points, rows, 4, 60);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> draw(-200, 200);
  for (int k = 0; k < 2000; ++k)
    EXPECT_EQ(body.patchAt(grid.closest({draw(random), draw(random), draw(random)})), patch::kFalciform);
}

TEST(ClosestPointGrid, QueriesFarOutsideAskTheMapsBorder) {
  const Surface ball = test::sphere(50, 3);
  const ClosestPointGrid grid(ball.points, allRows(ball.points), 4, 20);
  const Vector3d found = ball.points.row(grid.closest({1000, 0, 0}));
  EXPECT_GT(found.x(), 45);
}

TEST(ClosestPointGrid, OnePointAndAHugeExtentAreServed) {
  Points points(2, 3);
  points << 0, 0, 0, 1e5, 0, 0;
  const ClosestPointGrid one(points, {1}, 4, 10), wide(points, {0, 1}, 4, 10);
  EXPECT_EQ(one.closest({0, 0, 0}), 1);
  EXPECT_EQ(wide.closest({10, 0, 0}), 0);
  EXPECT_EQ(wide.closest({9.9e4F, 0, 0}), 1);
}

}  // namespace
}  // namespace falciform
