#include "Logic/Acquisition/SyntheticDeformation.h"

#include <gtest/gtest.h>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>

#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Testing/Logic/Acquisition/SyntheticLivers.h"

namespace falciform {
namespace {

using test::coarseLiver;

double rms(const Points& difference) { return std::sqrt(difference.rowwise().squaredNorm().mean()); }

TEST(SyntheticDeformation, HasTheStatedRms) {
  const Points& points = coarseLiver().surface.points;
  for (const double mm : {0.0, 2.0, 8.0}) {
    SyntheticDeformationSettings settings;
    settings.rmsMm = mm;
    EXPECT_NEAR(rms(drawDisplacement(points, settings).moved(points) - points), mm, 1e-9);  // mm, rounding
  }
}

TEST(SyntheticDeformation, HoldsNoRigidMotion) {
  const Points& points = coarseLiver().surface.points;
  const Points moved = drawDisplacement(points, {}).moved(points);
  // Kabsch: the best rotation and translation between the two must be nearly nil.
  const Vector3d a = centroid(points), b = centroid(moved);
  EXPECT_LT((a - b).norm(), 1e-9);  // mm, rounding
  const Matrix3d cross = (points.rowwise() - a.transpose()).transpose() * (moved.rowwise() - b.transpose());
  const Eigen::JacobiSVD<Matrix3d> svd(cross, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double degrees =
      Eigen::AngleAxisd(Matrix3d(svd.matrixV() * svd.matrixU().transpose())).angle() * 180 / M_PI;
  EXPECT_LT(degrees, 0.1);  // taken out to first order; second-order terms of 5 mm in 100 mm are left
}

TEST(SyntheticDeformation, GradientIsTheFieldsDerivative) {
  const SmoothDisplacement u = drawDisplacement(coarseLiver().surface.points, {});
  const Vector3d p(-30, 12, 20);
  constexpr double kStep = 1e-4;  // mm
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d h = kStep * Vector3d::Unit(axis);
    const Vector3d numeric = (u.at(p + h) - u.at(p - h)) / (2 * kStep);
    EXPECT_LT((numeric - u.gradient(p).col(axis)).norm(), 1e-8)
        << axis;  // central difference of a smooth field
  }
}

TEST(SyntheticDeformation, MovesSurfaceStructuresAndTargetsByOneField) {
  const SyntheticLiver& before = coarseLiver();
  const SyntheticLiver after = deformSynthetic(before, {});
  const SmoothDisplacement u = drawDisplacement(before.surface.points, {});
  EXPECT_TRUE(after.surface.points == u.moved(before.surface.points));
  EXPECT_TRUE(after.surface.triangles == before.surface.triangles);
  EXPECT_EQ(after.surface.patch, before.surface.patch);
  for (const auto& [name, structure] : before.structures)
    EXPECT_TRUE(after.structures.at(name).points == u.moved(structure.points));
  for (std::size_t i = 0; i < before.targets.points.size(); ++i) {
    const Vector3d p = before.targets.points[i].position;
    EXPECT_LT((after.targets.points[i].position - p - u.at(p)).norm(), 1e-12);
    EXPECT_EQ(after.targets.points[i].name, before.targets.points[i].name);
  }
  EXPECT_TRUE(inspectTopology(after.surface).closedManifold());
  EXPECT_NEAR(signedVolume(after.surface), signedVolume(before.surface),
              0.02 * signedVolume(before.surface));  // second order of the strain
  EXPECT_LT((after.surface.normals - vertexNormals(after.surface)).norm(), 1e-9);
}

TEST(SyntheticDeformation, IsSmooth) {
  // Points of 5 mm edges differ by far less than they move.
  const SyntheticLiver& before = coarseLiver();
  const Points difference = deformSynthetic(before, {}).surface.points - before.surface.points;
  double steepest = 0;
  for (Index t = 0; t < before.surface.triangles.rows(); ++t) {
    const int a = before.surface.triangles(t, 0), b = before.surface.triangles(t, 1);
    steepest = std::max(steepest, (difference.row(a) - difference.row(b)).norm() /
                                      (before.surface.points.row(a) - before.surface.points.row(b)).norm());
  }
  EXPECT_LT(steepest, 0.5);  // strain
}

TEST(SyntheticDeformation, SeedsDiffer) {
  const Points& points = coarseLiver().surface.points;
  SyntheticDeformationSettings other;
  other.seed = 2;
  EXPECT_GT(rms(drawDisplacement(points, {}).moved(points) - drawDisplacement(points, other).moved(points)),
            2);
}

TEST(SyntheticDeformation, RefusesToFoldTheLiver) {
  const Points& points = coarseLiver().surface.points;
  SyntheticDeformationSettings settings;
  settings.rmsMm = 25;
  settings.wavelengthMm = 100;
  int refused = 0;
  for (settings.seed = 1; settings.seed <= 20; ++settings.seed) try {
      const SmoothDisplacement u = drawDisplacement(points, settings);
      for (Index i = 0; i < points.rows(); ++i)
        ASSERT_GE((Matrix3d::Identity() + u.gradient(points.row(i).transpose())).determinant(), 0.2);
    } catch (const InputError&) {
      ++refused;
    }
  EXPECT_GT(refused, 10);  // a quarter of the wavelength, root mean square: nearly all fold
}

TEST(SyntheticDeformation, RefusesWhatIsNoDeformation) {
  SyntheticDeformationSettings settings;
  settings.rmsMm = -1;
  EXPECT_THROW((void)deformSynthetic(coarseLiver(), settings), InputError);
  EXPECT_THROW((void)drawDisplacement(Points(0, 3), {}), InputError);
}

}  // namespace
}  // namespace falciform
