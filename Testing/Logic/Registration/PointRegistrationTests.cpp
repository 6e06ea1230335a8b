#include "Logic/Registration/PointRegistration.h"

#include <gtest/gtest.h>

#include <random>

#include "Logic/Core/Errors.h"
#include "Testing/Logic/Registration/PartialScan.h"

namespace falciform {
namespace {

using test::randomMotion;

Points randomPoints(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> coordinate(0, 50);
  Points points(count, 3);
  for (Index i = 0; i < points.size(); ++i) points.data()[i] = coordinate(random);
  return points;
}

Landmarks landmarksOf(const Points& points) {
  Landmarks landmarks;
  for (Index i = 0; i < points.rows(); ++i)
    landmarks.points.push_back({"P" + std::to_string(i), points.row(i).transpose()});
  return landmarks;
}

TEST(FitRigid, RecoversAnyMotionExactly) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Points source = randomPoints(3 + static_cast<int>(seed) % 20, seed);
    const Isometry3d truth = randomMotion(seed + 100);
    const Isometry3d found = fitRigid(source, transformed(source, truth));
    EXPECT_LT(test::placedApart(source, found, truth),
              1e-9);  // mm: rounding of coordinates of a few hundred mm
  }
}

TEST(FitRigid, GivesARotationEvenForMirroredPoints) {
  const Points source = randomPoints(20, 4);
  Points mirrored = source;
  mirrored.col(0) *= -1;
  EXPECT_NEAR(fitRigid(source, mirrored).linear().determinant(), 1, 1e-12);
}

TEST(FitRigid, AWeightOfTwoCountsAsThePointTwice) {
  const Points source = randomPoints(6, 5), target = randomPoints(6, 6);
  Points source7(7, 3), target7(7, 3);
  source7 << source, source.row(2);
  target7 << target, target.row(2);
  VectorXd weights = VectorXd::Ones(6);
  weights[2] = 2;
  EXPECT_LT(test::placedApart(source, fitRigid(source, target, weights), fitRigid(source7, target7)), 1e-9);
}

TEST(FitRigid, NoSmallMotionFitsBetter) {
  const Points source = randomPoints(12, 7), target = randomPoints(12, 8);
  const VectorXd weights = randomPoints(12, 9).col(0).cwiseAbs();
  const Isometry3d best = fitRigid(source, target, weights);
  const auto energy = [&](const Isometry3d& pose) {
    return weights.dot(targetErrors(source, target, pose).cwiseAbs2());
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const double step : {-1e-3, 1e-3}) {
      EXPECT_GE(energy(Eigen::Translation3d(step * Vector3d::Unit(axis)) * best), energy(best));
      EXPECT_GE(energy(best * Eigen::AngleAxisd(step, Vector3d::Unit(axis))), energy(best));
    }
}

TEST(FitRigid, AgreesWithHornsQuaternion) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Points source = randomPoints(8, seed), target = randomPoints(8, seed + 1000);
    const VectorXd weights = randomPoints(8, seed + 2000).col(0).cwiseAbs();
    EXPECT_LT(
        test::placedApart(source, fitRigid(source, target, weights), fitRigidHorn(source, target, weights)),
        1e-7);
  }
}

TEST(RegisterPoints, MatchesByNameWhateverTheOrder) {
  const Points source = randomPoints(5, 1);
  const Isometry3d truth = randomMotion(2);
  Landmarks target = landmarksOf(transformed(source, truth));
  std::reverse(target.points.begin(), target.points.end());
  const PointRegistrationResult result = registerPoints(landmarksOf(source), target);
  EXPECT_LT(test::placedApart(source, result.targetFromSource, truth), 1e-9);
  EXPECT_LT(result.freMm, 1e-9);
}

TEST(RegisterPoints, RefusesWhatCannotGiveAPose) {
  const Landmarks five = landmarksOf(randomPoints(5, 1)), four = landmarksOf(randomPoints(4, 1));
  EXPECT_THROW((void)registerPoints(five, four), InputError);
  const Landmarks two = landmarksOf(randomPoints(2, 1));
  EXPECT_THROW((void)registerPoints(two, two), InputError);
  Points line(4, 3);
  line << 0, 0, 0, 1, 1, 1, 2, 2, 2, 5, 5, 5;
  EXPECT_THROW((void)registerPoints(landmarksOf(line), landmarksOf(line)), InputError);
  Landmarks broken = five;
  broken.points[1].position.y() = std::nan("");
  EXPECT_THROW((void)registerPoints(broken, five), InputError);
}

TEST(PredictedTre, MatchesASimulation) {
  // Fitzpatrick 1998 is exact to first order in FLE: with FLE 0.5 mm on a 100 mm set and 20,000 draws, 2 %
  // covers both errors.
  const Points fiducials = randomPoints(6, 3);
  const Vector3d target(40, -60, 80);
  const double fle = 0.5;
  std::mt19937 random(11);
  std::normal_distribution<double> error(0, fle / std::sqrt(3.0));
  double squared = 0;
  const int draws = 20000;
  for (int d = 0; d < draws; ++d) {
    Points noisy = fiducials;
    for (Index i = 0; i < noisy.size(); ++i) noisy.data()[i] += error(random);
    squared += (fitRigid(fiducials, noisy) * target - target).squaredNorm();
  }
  EXPECT_NEAR(predictedTre(fiducials, fle, target) / std::sqrt(squared / draws), 1, 0.02);
}

}  // namespace
}  // namespace falciform
