#include "Logic/Registration/Trials/Perturbations.h"

#include <cmath>

#include "Logic/Core/Draws.h"

namespace falciform {

namespace {

constexpr double kRadPerDeg = EIGEN_PI / 180;

Matrix3d eulerRotation(Draws& draws, double most) {
  const double x = draws.uniform(-most, most), y = draws.uniform(-most, most), z = draws.uniform(-most, most);
  using Eigen::AngleAxisd;
  return (AngleAxisd(z, Vector3d::UnitZ()) * AngleAxisd(y, Vector3d::UnitY()) *
          AngleAxisd(x, Vector3d::UnitX()))
      .toRotationMatrix();
}

Matrix3d uniformRotation(Draws& draws, double most) {
  const Vector3d axis = draws.direction();
  return Eigen::AngleAxisd(uniformRotationAngle(draws.uniform(), most), axis).toRotationMatrix();
}

}  // namespace

double uniformRotationAngle(double u, double most) {
  // Haar measure gives the angle the density (1 - cos t) / pi. Halving is slow and cannot fail: Newton's
  // derivative vanishes at 0.
  const double level = u * (most - std::sin(most));
  double low = 0, high = most;
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2;
    (middle - std::sin(middle) < level ? low : high) = middle;
  }
  return (low + high) / 2;
}

Isometry3d perturbation(const TrialScale& scale, TrialDistribution distribution, std::uint64_t seed,
                        std::uint64_t trial, const Vector3d& centre) {
  Draws draws(seed, trial);
  const double most = scale.rotationDeg * kRadPerDeg;
  const Matrix3d rotation =
      distribution == TrialDistribution::Euler ? eulerRotation(draws, most) : uniformRotation(draws, most);
  Vector3d shift;
  for (int axis = 0; axis < 3; ++axis) shift[axis] = draws.uniform(-scale.translationMm, scale.translationMm);
  Isometry3d motion = Isometry3d::Identity();
  motion.linear() = rotation;
  motion.translation() = centre - rotation * centre + shift;
  return motion;
}

}  // namespace falciform
