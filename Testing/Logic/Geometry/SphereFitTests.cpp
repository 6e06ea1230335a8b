#include "Logic/Geometry/SphereFit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "Logic/Core/Draws.h"
#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

const Vector3d kCentre(41.5, -120.25, 333.125);
constexpr double kRadius = 12.7;

/// `count` points on a sphere, none farther than `capDeg` from the direction (1, 2, -2), each moved along its
/// radius by normal noise.
Points cap(int count, double capDeg, double noiseMm, std::uint64_t seed, double radius = kRadius) {
  const Vector3d axis = Vector3d(1, 2, -2) / 3, side = axis.unitOrthogonal(), other = axis.cross(side);
  Draws draws(seed);
  Points points(count, 3);
  for (Index i = 0; i < count; ++i) {
    const double height = draws.uniform(std::cos(capDeg * M_PI / 180), 1), turn = draws.uniform(0, 2 * M_PI);
    const double ring = std::sqrt(1 - height * height);
    const Vector3d n = height * axis + ring * (std::cos(turn) * side + std::sin(turn) * other);
    points.row(i) = (kCentre + (radius + noiseMm * draws.normal()) * n).transpose();
  }
  return points;
}

double centreError(const SphereFit& fit) { return (fit.centre - kCentre).norm(); }

TEST(SphereFit, FindsAnExactSphereExactly) {
  for (const double capDeg : {180.0, 90.0, 40.0, 15.0}) {
    const Points points = cap(200, capDeg, 0, 1);
    for (const SphereFit& fit : {fitSphereAlgebraic(points), fitSphere(points), fitSphereRobust(points),
                                 fitSphere(points, kRadius), fitSphereRobust(points, kRadius)}) {
      EXPECT_TRUE(fit.converged) << capDeg;
      EXPECT_LT(centreError(fit), 1e-8) << capDeg;  // mm: coordinates of 300 mm, conditioning of a small cap
      EXPECT_NEAR(fit.radiusMm, kRadius, 1e-8) << capDeg;
      EXPECT_LT(fit.rmsMm, 1e-10) << capDeg;
    }
  }
}

TEST(SphereFit, FourPointsAreEnough) {
  const SphereFit fit = fitSphere(cap(4, 180, 0, 3));
  EXPECT_LT(centreError(fit), 1e-8);  // mm
  EXPECT_EQ(fit.used, 4);
}

/// Over many draws of the noise: RMS error of the centre, and what the fits themselves expected.
struct Spread {
  double actual = 0, expected = 0, bias = 0;
};
template <class Fit>
Spread spreadOf(int count, double capDeg, double noiseMm, const Fit& fit) {
  constexpr int kDraws = 400;
  Spread spread;
  Vector3d mean = Vector3d::Zero();
  for (int draw = 0; draw < kDraws; ++draw) {
    const SphereFit found = fit(cap(count, capDeg, noiseMm, 100 + static_cast<std::uint64_t>(draw)));
    EXPECT_TRUE(found.converged);
    spread.actual += std::pow(centreError(found), 2) / kDraws;
    spread.expected += std::pow(found.centreErrorMm, 2) / kDraws;
    mean += (found.centre - kCentre) / kDraws;
  }
  spread.actual = std::sqrt(spread.actual);
  spread.expected = std::sqrt(spread.expected);
  spread.bias = mean.norm();
  return spread;
}

TEST(SphereFit, ErrorUnderNoiseIsTheCramerRaoBound) {
  // With radial noise s the bound is s^2 (J^T J)^-1: over the whole sphere, with the radius known, J^T J =
  // n/3 I, so the centre's error is 3 s / sqrt(n). 400 draws know it to 1 / sqrt(2 * 3 * 400) = 2 %.
  const Spread whole = spreadOf(300, 180, 0.5, [](const Points& p) { return fitSphere(p, kRadius); });
  EXPECT_NEAR(whole.actual, 3 * 0.5 / std::sqrt(300), 0.1 * 3 * 0.5 / std::sqrt(300));
  for (const double capDeg : {90.0, 60.0}) {
    for (const bool known : {true, false}) {
      const Spread s = spreadOf(
          300, capDeg, 0.3, [&](const Points& p) { return known ? fitSphere(p, kRadius) : fitSphere(p); });
      EXPECT_NEAR(s.actual, s.expected, 0.15 * s.expected) << capDeg << ' ' << known;
      EXPECT_LT(s.bias, 0.25 * s.actual) << capDeg << ' ' << known;  // 1/20 by chance; noise^2 / r besides
    }
  }
}

TEST(SphereFit, OrthogonalDistancesAreLessBiasedThanTheAlgebraicFitOnACap) {
  const Spread algebraic = spreadOf(300, 50, 0.5, [](const Points& p) { return fitSphereAlgebraic(p); });
  const Spread geometric = spreadOf(300, 50, 0.5, [](const Points& p) { return fitSphere(p); });
  EXPECT_LT(geometric.bias, 0.5 * algebraic.bias);
}

TEST(SphereFit, KnowingTheRadiusHelpsOnACap) {
  const Spread free = spreadOf(300, 50, 0.3, [](const Points& p) { return fitSphere(p); });
  const Spread known = spreadOf(300, 50, 0.3, [](const Points& p) { return fitSphere(p, kRadius); });
  EXPECT_LT(known.actual, 0.5 * free.actual);
}

TEST(SphereFit, RobustFitIsNotMovedByAThirdOfOutliers) {
  // A flat neighbour and clutter: the plain fit is off by millimetres, the robust one keeps to the noise.
  Points points(300, 3);
  points.topRows(200) = cap(200, 80, 0.5, 7);
  Draws draws(8);
  for (Index i = 200; i < 260; ++i)
    points.row(i) << kCentre.x() + draws.uniform(-20, 20), kCentre.y() + draws.uniform(-20, 20),
        kCentre.z() + 18 + 0.5 * draws.normal();
  for (Index i = 260; i < 300; ++i) points.row(i) = (kCentre + 20 * draws.normal3()).transpose();
  const SphereFit robust = fitSphereRobust(points, kRadius);
  EXPECT_TRUE(robust.converged);
  EXPECT_GT(centreError(fitSphere(points, kRadius)), 1);
  EXPECT_LT(centreError(robust), 0.25);  // mm: twice the bound of 3 x 0.5 / sqrt(200)
  EXPECT_NEAR(static_cast<double>(robust.used), 200, 20);
  EXPECT_NEAR(robust.rmsMm, 0.5, 0.1);
}

TEST(SphereFit, RobustFitLosesLittleWithoutOutliers) {
  const Spread plain = spreadOf(150, 80, 0.5, [](const Points& p) { return fitSphere(p, kRadius); });
  const Spread robust = spreadOf(150, 80, 0.5, [](const Points& p) { return fitSphereRobust(p, kRadius); });
  EXPECT_LT(robust.actual, 1.1 * plain.actual);  // Tukey's weights at 4.685: 95 % efficient
}

TEST(SphereFit, MovesWithItsPoints) {
  const Points points = cap(100, 70, 0.4, 11);
  Isometry3d motion = Isometry3d::Identity();
  motion.rotate(Eigen::AngleAxisd(1.1, Vector3d(0.3, -1, 0.4).normalized()));
  motion.translation() = Vector3d(90, -30, 12);
  const Points moved = (points * motion.linear().transpose()).rowwise() + motion.translation().transpose();
  for (const bool robust : {false, true}) {
    const SphereFit here = robust ? fitSphereRobust(points) : fitSphere(points),
                    there = robust ? fitSphereRobust(moved) : fitSphere(moved);
    EXPECT_LT((motion * here.centre - there.centre).norm(), 1e-6);  // mm: both stop at 1e-10 a step
    EXPECT_NEAR(here.radiusMm, there.radiusMm, 1e-6);
  }
}

TEST(SphereFit, RefusesWhatHasNoSphere) {
  EXPECT_THROW((void)fitSphere(cap(3, 90, 0, 1)), InputError);
  EXPECT_THROW((void)fitSphere(Points(0, 3)), InputError);
  Points flat = cap(50, 90, 0, 1);
  flat.col(2).setConstant(5);
  EXPECT_THROW((void)fitSphere(flat), InputError);
  EXPECT_THROW((void)fitSphereRobust(flat), InputError);
  EXPECT_THROW((void)fitSphereRobust(Points::Zero(10, 3)), InputError);
  Points broken = cap(50, 90, 0, 1);
  broken(7, 1) = std::nan("");
  EXPECT_THROW((void)fitSphere(broken), InputError);
  EXPECT_THROW((void)fitSphereRobust(broken, kRadius), InputError);
}

}  // namespace
}  // namespace falciform
