#include "Logic/Registration/PreparedPreop.h"

#include <gtest/gtest.h>

#include "Logic/Core/Draws.h"
#include "Logic/Geometry/TrianglePlaces.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

TEST(PreparedPreop, AWalkEndsAtTheNearestPlaceOfTheSurface) {
  const Surface body = test::lumpyBody(4);
  const PreparedPreop preop(body);
  Draws draws(5);
  int walked = 0;
  for (Index i = 0; i < body.size(); i += 20) {
    const Vector3d from = body.points.row(i).transpose() + draws.normal3();
    const Vector3d to = from + 2 * draws.normal3();
    int near = preop.target().closest(from, 0, 1).index;
    const int before = near;
    const PreparedPreop::Place place = preop.placeByWalk(preop.placeAround(near, from), near, to);
    double least = std::numeric_limits<double>::infinity();
    for (Index t = 0; t < body.triangles.rows(); ++t) {
      const auto corners = body.triangles.row(t);
      least = std::min(least, detail::closestByRegions(to, {body.points.row(corners[0]).transpose(),
                                                            body.points.row(corners[1]).transpose(),
                                                            body.points.row(corners[2]).transpose()})
                                  .squaredDistance);
    }
    EXPECT_NEAR((place.point - to).norm(), std::sqrt(least), 1e-9);
    EXPECT_NEAR(place.normal.norm(), 1, 1e-12);
    walked += near != before;
  }
  EXPECT_GT(walked, 10);
}

TEST(PreparedPreop, TrianglesWithoutAreaLeaveNoHole) {
  // Edges of no width, first among the triangles around each corner of a body.
  Surface body = test::lumpyBody(2);
  const Triangles whole = body.triangles;
  body.triangles.resize(2 * whole.rows(), 3);
  for (Index t = 0; t < whole.rows(); ++t) {
    const int a = whole(t, 0), b = whole(t, 1);
    body.triangles.row(t) = t % 2 == 0 ? Eigen::RowVector3i(a, a, b) : Eigen::RowVector3i(b, a, b);
  }
  body.triangles.bottomRows(whole.rows()) = whole;
  const PreparedPreop preop(body), sound(test::lumpyBody(2));
  Draws draws(6);
  for (int i = 0; i < body.size(); ++i) {
    const Vector3d from = body.points.row(i).transpose() + draws.normal3(), to = from + 0.2 * draws.normal3();
    int near = i, other = i;
    const PreparedPreop::Place last = sound.placeAround(i, from);
    ASSERT_NEAR((preop.placeAround(i, from).point - last.point).norm(), 0, 1e-9);
    const PreparedPreop::Place place = preop.placeByWalk(preop.placeAround(i, from), near, to);
    ASSERT_NEAR((place.point - sound.placeByWalk(last, other, to).point).norm(), 0, 1e-9);
    ASSERT_NEAR(place.normal.norm(), 1, 1e-12);
  }
}

}  // namespace
}  // namespace falciform
