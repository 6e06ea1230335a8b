#include "Logic/Registration/ElasticModes.h"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using Coefficients = ElasticModes::Coefficients;
using Stacked = Eigen::Matrix<double, ElasticModes::kUnknowns, 1>;

double energyOf(const ElasticModes& modes, const Coefficients& u) {
  const Eigen::Map<const Stacked> q(u.data());
  return q.dot(modes.energy() * q);
}

/// Coefficients of u(x) = A x + b, found by evaluating: the modes' own coordinates stay their own affair.
Coefficients affine(const ElasticModes& modes, const Matrix3d& a, const Vector3d& b) {
  // The first four monomials are 1 and the scaled coordinates: solve for them from four places.
  Eigen::Matrix4d values;
  Eigen::Matrix<double, 4, 3> wanted;
  const Vector3d places[] = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}};
  for (int k = 0; k < 4; ++k) {
    values.row(k) = modes.monomials(places[k]).head<4>();
    wanted.row(k) = (a * places[k] + b).transpose();
  }
  Coefficients u = Coefficients::Zero();
  u.topRows<4>() = values.partialPivLu().solve(wanted);
  return u;
}

TEST(ElasticModes, RigidMotionsCostNothing) {
  const ElasticModes modes(test::lumpyBody(3));
  Matrix3d turn;
  turn << 0, -0.1, 0.2, 0.1, 0, -0.3, -0.2, 0.3, 0;
  const double price = energyOf(modes, affine(modes, turn, {5, -3, 8}));
  EXPECT_NEAR(price, 0, 1e-12);  // against 0.1 for a strain of the same size
}

TEST(ElasticModes, HomogeneousStrainCostsItsDensity) {
  const double nu = 0.3;
  const ElasticModes modes(test::sphere(60, 3, {10, 20, 30}), nu);
  Matrix3d strain;
  strain << 0.10, 0.02, 0, 0.02, -0.03, 0.01, 0, 0.01, 0.05;
  const double expected = strain.squaredNorm() + nu / (1 - 2 * nu) * strain.trace() * strain.trace();
  EXPECT_NEAR(energyOf(modes, affine(modes, strain, Vector3d::Zero())), expected, 1e-12);
}

TEST(ElasticModes, AGradientOfStrainCostsMoreThanItsStrain) {
  // u = (g (x - x0)^2 / 2, 0, 0) over a ball of radius r about x0: strain g (x - x0), mean square g^2 r^2 /
  // 5; second gradient g. The monomials after 1, x, y, z begin with x^2.
  const double nu = 0.3, r = 60, g = 1e-3;
  const ElasticModes modes(test::sphere(r, 5, {10, 20, 30}), nu);
  const double atRim = modes.monomials({10 + r, 20, 30})[4];  // the scaled square is r^2 in mm^2
  Coefficients u = Coefficients::Zero();
  u(4, 0) = g * r * r / 2 / atRim;
  const double strain = (1 + nu / (1 - 2 * nu)) * g * g * r * r / 5;
  const double smooth = ElasticModes::kSmoothness * r * r * g * g;
  EXPECT_NEAR(energyOf(modes, u), strain + smooth, 0.005 * (strain + smooth));
}

TEST(ElasticModes, EnergyIsPositiveForAllElse) {
  const ElasticModes modes(test::lumpyBody(3));
  const Eigen::SelfAdjointEigenSolver<ElasticModes::Energy> eigen(modes.energy());
  const auto values = eigen.eigenvalues();
  EXPECT_NEAR(values[5] / values[59], 0, 1e-12);  // six rigid motions
  EXPECT_GT(values[6] / values[59], 1e-6);
}

TEST(ElasticModes, MeansAreThoseOfTheBall) {
  // Over a ball of radius r the mean of x^2 is r^2 / 5: u = (x, 0, 0) has the root mean square r / sqrt 5.
  const ElasticModes modes(test::sphere(60, 5));
  Matrix3d stretch = Matrix3d::Zero();
  stretch(0, 0) = 1;
  // The icosphere of five subdivisions lies 0.1 % inside its ball.
  EXPECT_NEAR(modes.rootMeanSquare(affine(modes, stretch, Vector3d::Zero())), 60 / std::sqrt(5.0), 0.1);
}

TEST(ElasticModes, RigidPartOfARigidMotionIsTheMotion) {
  const ElasticModes modes(test::lumpyBody(3));
  const Isometry3d motion = test::randomMotion(4, 50);
  const Coefficients u = affine(modes, motion.linear() - Matrix3d::Identity(), motion.translation());
  EXPECT_LT((modes.rigidPart(u).matrix() - motion.matrix()).norm(), 1e-9);
  EXPECT_LT(modes.without(motion, u).norm(), 1e-9);
}

TEST(ElasticModes, WithoutItsRigidPartNothingRigidIsLeft) {
  const ElasticModes modes(test::lumpyBody(3));
  Coefficients u = Coefficients::Zero();
  std::srand(5);
  u = 8 * Coefficients::Random();
  const Isometry3d rigid = modes.rigidPart(u);
  const Coefficients rest = modes.without(rigid, u);
  EXPECT_LT((modes.rigidPart(rest).matrix() - Isometry3d::Identity().matrix()).norm(), 1e-9);
  for (const Vector3d& x : {Vector3d(0, 0, 0), Vector3d(40, -20, 10), Vector3d(-5, 30, 60)}) {
    const Vector3d whole = x + modes.displacement(u, x);
    EXPECT_LT((rigid * (x + modes.displacement(rest, x)) - whole).norm(), 1e-9);
  }
}

TEST(ElasticModes, AnOpenSheetIsMeasuredByItsSurface) {
  const ElasticModes modes(test::grid(100, 20));
  EXPECT_TRUE(modes.energy().allFinite());
  EXPECT_NEAR(energyOf(modes, affine(modes, Matrix3d::Zero(), {1, 2, 3})), 0, 1e-12);
}

}  // namespace
}  // namespace falciform
