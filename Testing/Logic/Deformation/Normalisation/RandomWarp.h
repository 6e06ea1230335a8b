#pragma once
#include <random>

#include "Logic/Deformation/Normalisation/BasisWarp.h"

namespace falciform::test {

/// A warp over the cube from 0 to 60 mm whose coefficients are uniform up to `largestMm` along each axis.
[[nodiscard]] inline BasisWarp randomWarp(unsigned seed, double spacingMm, double largestMm) {
  const int count = static_cast<int>(60 / spacingMm) + 1;
  BasisWarp warp(Vector3d::Zero(), spacingMm, Vector3i::Constant(count));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-largestMm, largestMm);
  for (Index i = 0; i < warp.coefficients.size(); ++i) warp.coefficients.data()[i] = uniform(random);
  return warp;
}

/// Uniform in the cube from -10 to 70 mm, so beyond the lattice too.
[[nodiscard]] inline Points randomPlaces(unsigned seed, Index count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-10, 70);
  Points places(count, 3);
  for (Index i = 0; i < places.size(); ++i) places.data()[i] = uniform(random);
  return places;
}

}  // namespace falciform::test
