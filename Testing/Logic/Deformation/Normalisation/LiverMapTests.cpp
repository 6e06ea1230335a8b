#include "Logic/Deformation/Normalisation/LiverMap.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "Testing/Logic/Deformation/Normalisation/RandomWarp.h"

namespace falciform::test {
namespace {

LiverMap someMap() {
  LiverMap map;
  map.sourceFromTarget = Eigen::Translation3d(3, -5, 2) *
                         Eigen::AngleAxisd(0.3, Vector3d(1, 2, 3).normalized()) *
                         Eigen::Scaling(1.1, 0.9, 1.2);
  for (const double spacing : {30.0, 15.0, 10.0}) {
    map.warps.push_back(randomWarp(static_cast<unsigned>(spacing), spacing, spacing));
    map.warps.back().limitCompression(0.5);
  }
  return map;
}

TEST(LiverMap, ToTargetUndoesToSource) {
  const LiverMap map = someMap();
  const Points places = randomPlaces(1, 1000);
  EXPECT_LT((map.toTarget(map.toSource(places)) - places).rowwise().norm().maxCoeff(), 1e-6);
}

TEST(LiverMap, DeterminantsAreThoseOfTheWholeChain) {
  const LiverMap map = someMap();
  const Points places = randomPlaces(2, 100);
  const VectorXd determinants = map.determinants(places);
  constexpr double kStep = 1e-4;  // mm
  std::array<Points, 3> ahead, behind;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::RowVector3d step = kStep * Eigen::RowVector3d::Unit(axis);
    ahead[static_cast<std::size_t>(axis)] = map.toSource(places.rowwise() + step);
    behind[static_cast<std::size_t>(axis)] = map.toSource(places.rowwise() - step);
  }
  for (Index i = 0; i < places.rows(); ++i) {
    Matrix3d gradient;
    for (std::size_t axis = 0; axis < 3; ++axis)
      gradient.col(static_cast<Index>(axis)) =
          (ahead[axis].row(i) - behind[axis].row(i)).transpose() / (2 * kStep);
    EXPECT_NEAR(determinants[i], gradient.determinant(), 1e-5);
    EXPECT_GT(determinants[i], 0);
  }
}

}  // namespace
}  // namespace falciform::test
