#include "Logic/Deformation/Cohort/CarriedCase.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "Logic/Core/Errors.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {
namespace {

/// No symmetry but one plane, so that a registration of it is told.
Surface lump(double scale) {
  Surface surface = sphere(50, 4);
  for (Index v = 0; v < surface.size(); ++v) {
    const Vector3d n = surface.points.row(v).transpose().normalized();
    surface.points.row(v) = scale * (50 + 12 * n.x() + 8 * n.x() * n.z() + 5 * n.y() * n.y()) *
                            Vector3d(1.4, 0.8, 1).cwiseProduct(n);
  }
  return surface;
}

/// A field of places.
VectorXd heights(const Points& points) { return points.col(2) + 0.3 * points.col(0); }

TEST(CarriedCase, AValueThatIsLinearInSpaceIsExactOnTheSurface) {
  const Surface surface = sphere(30, 3);
  Points places(200, 3);
  for (Index i = 0; i < places.rows(); ++i) {
    const auto corners = surface.triangles.row(i % surface.triangles.rows());
    places.row(i) = 0.5 * surface.points.row(corners[0]) + 0.3 * surface.points.row(corners[1]) +
                    0.2 * surface.points.row(corners[2]);
  }
  const Eigen::MatrixXd carried = valuesAt(surface, heights(surface.points), places, 1);
  EXPECT_LT((carried.col(0) - heights(places)).cwiseAbs().maxCoeff(), 1e-12);  // mm: rounding alone
}

TEST(CarriedCase, PlacesOutOfReachOrBesideAVertexWithoutValueHaveNone) {
  const Surface surface = sphere(30, 3);
  Eigen::MatrixXd values = heights(surface.points);
  const int bare = surface.triangles(0, 0);
  values(bare, 0) = std::nan("");
  const auto middle =
      (surface.points.row(surface.triangles(0, 0)) + surface.points.row(surface.triangles(0, 1)) +
       surface.points.row(surface.triangles(0, 2)))
          .eval() /
      3;
  Points places(4, 3);
  places.row(0) = middle;                                             // of a triangle of that vertex
  places.row(1) = surface.points.row(surface.triangles(0, 1));        // its neighbour itself
  places.row(2) = 1.1 * surface.points.row(surface.triangles(0, 1));  // 3 mm outside
  places.row(3) = surface.points.row(bare);
  const Eigen::MatrixXd carried = valuesAt(surface, values, places, 2);
  EXPECT_TRUE(std::isnan(carried(0, 0)));
  EXPECT_NEAR(carried(1, 0), values(surface.triangles(0, 1), 0), 1e-9);
  EXPECT_TRUE(std::isnan(carried(2, 0)));
  EXPECT_TRUE(std::isnan(carried(3, 0)));
  EXPECT_THROW((void)valuesAt(surface, Eigen::MatrixXd::Zero(3, 1), places, 2), InputError);
}

TEST(CarriedCase, APatternOfOneLiverIsFoundAgainOnALargerOneThatLiesElsewhere) {
  const Surface source = lump(1);
  Surface target = lump(1.15);
  const Eigen::RowVector3d offset(20, -5, 10);
  target.points.rowwise() += offset;
  const auto pattern = [](double x) { return std::sin(x / 15); };
  Eigen::MatrixXd values(source.size(), 1);
  for (Index v = 0; v < source.size(); ++v) values(v, 0) = pattern(source.points(v, 0));
  const CarriedCase carried = carryCase(target, source, values, {.levels = 6, .finestMm = 14});
  EXPECT_GT(carried.leastDeterminant, 0);
  ASSERT_EQ(carried.values.rows(), target.size());
  double worst = 0;
  for (Index v = 0; v < target.size(); ++v)
    worst =
        std::max(worst, std::abs(carried.values(v, 0) - pattern((target.points(v, 0) - offset.x()) / 1.15)));
  // The pattern rises by 1 in 15 mm; surfaces that agree leave a millimetre or two along them undecided.
  EXPECT_LT(worst, 0.25);
  EXPECT_LT(carried.targetToSource.mean(), 0.5);  // mm
  EXPECT_EQ(carried.sourceToTarget.size(), source.size());
}

TEST(CarriedCase, NormalDisplacementIsBlindToRigidMotionAndSeesSwelling) {
  const Surface surface = sphere(40, 4);
  Isometry3d motion = Isometry3d::Identity();
  motion.rotate(Eigen::AngleAxisd(0.8, Vector3d(1, 2, -1).normalized()));
  motion.pretranslate(Vector3d(30, -200, 5));
  EXPECT_LT(normalDisplacement(surface, transformed(surface.points, motion)).cwiseAbs().maxCoeff(), 1e-9);
  const VectorXd grown = normalDisplacement(surface, transformed(1.05 * surface.points, motion));
  EXPECT_NEAR(grown.minCoeff(), 2, 1e-3);  // mm: vertex normals of a sphere of triangles are not quite radial
  EXPECT_NEAR(grown.maxCoeff(), 2, 1e-3);
}

}  // namespace
}  // namespace falciform::test
