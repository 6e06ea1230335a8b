// The solutions behind held-out truths, on blocks small enough for CalculiX to take a second.
#include <gtest/gtest.h>

#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Testing/Benchmarks/Truths/TruthBody.h"
#include "Testing/Benchmarks/Truths/TruthFiles.h"
#include "Testing/Support/BlockMesh.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::bench {
namespace {

const Vector3d kSize(60, 30, 30);

/// A block whose two ends go where `end` sends them.
template <class End>
TruthBody heldAtEnds(const End& end) {
  TruthBody body;
  body.problem.name = "block";
  body.problem.neoHookean = true;
  verification::HeldBody& held = body.problem.body;
  held.mesh = quadraticMesh(test::shakenBlockMesh(kSize, {4, 2, 2}, 0.2, 3));
  held.materials = {{.youngsModulusMPa = 0.006, .poissonsRatio = 0.46}};
  held.forces = Points::Zero(held.mesh.nodes(), 3);
  for (Index n = 0; n < held.mesh.nodes(); ++n) {
    const Vector3d place = held.mesh.points.row(n).transpose();
    if (place.x() < 1e-9 || place.x() > kSize.x() - 1e-9)
      held.constraints.push_back({.node = static_cast<int>(n), .valuesMm = end(place) - place});
  }
  return body;
}

constexpr double kPressMm = 58;

/// One end 58 mm towards the other, 60 mm away.
Vector3d pressed(const Vector3d& place) {
  return place.x() < 1 ? place : Vector3d(place - kPressMm * Vector3d::UnitX());
}

TEST(TruthSolve, EndsCarriedRigidlyCarryTheWholeBlockWithoutStrain) {
  const auto calculix = verification::findCalculix();
  if (!calculix) GTEST_SKIP() << "CalculiX is not installed (Debian: calculix-ccx)";
  // 40 degrees: a linear solver would stretch the block by a quarter.
  Isometry3d motion = Isometry3d::Identity();
  motion.rotate(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 2).normalized()));
  motion.translation() = Vector3d(5, -3, 8);
  const TruthBody body = heldAtEnds([&](const Vector3d& p) { return Vector3d(motion * p); });
  const test::TemporaryFolder folder;
  const TruthState state = solveTruth(body, *calculix, folder.path());
  EXPECT_EQ(state.share, 1);
  const TruthTargets targets = drawTargets(body.problem.body.mesh, state.displacements, 40, 5);
  // CalculiX ends its iterations at half a hundredth of the residual: 0.01 mm of 40.
  const double astray = (targets.moved - transformed(targets.preop, motion)).rowwise().norm().maxCoeff();
  EXPECT_LT(astray, 0.02);
  EXPECT_LT(optimalRigidMm(targets), 0.02);
  EXPECT_NEAR(state.minDetJ, 1, 1e-3);
}

TEST(TruthSolve, WhatWouldCrushTheTissueIsTakenInPartAndSaysWhy) {
  const auto calculix = verification::findCalculix();
  if (!calculix) GTEST_SKIP() << "CalculiX is not installed (Debian: calculix-ccx)";
  const TruthBody body = heldAtEnds(pressed);
  const test::TemporaryFolder folder;
  const TruthState state = solveTruth(body, *calculix, folder.path());
  EXPECT_GT(state.share, 0.3);
  EXPECT_LT(state.share, 0.9);
  EXPECT_GE(state.minDetJ, 0.1);
  ASSERT_FALSE(state.refused.empty());
  EXPECT_NE(state.refused.front().find("share 1.000"), std::string::npos) << state.refused.front();
  // The whole way is known, so the nodes that are carried tell the share.
  double most = 0;
  for (const NodeConstraint& c : body.problem.body.constraints)
    most = std::max(most, state.displacements.row(c.node).norm());
  EXPECT_NEAR(most, state.share * kPressMm, 1e-4 * kPressMm);  // CalculiX prints times to seven digits
}

TEST(TruthSolve, AStateOnTheWayIsTheSolutionWithThatShareOfTheLoad) {
  const auto calculix = verification::findCalculix();
  if (!calculix) GTEST_SKIP() << "CalculiX is not installed (Debian: calculix-ccx)";
  TruthBody body = heldAtEnds(pressed);
  body.problem.gravityMPerS2 = {3, -2, 8};
  const test::TemporaryFolder folder;
  const auto path = verification::loadPathWithCalculix(body.problem, *calculix, folder / "path");
  ASSERT_GE(path.size(), 2U);
  const verification::LoadState& state = path[1];
  EXPECT_GT(state.share, path[0].share);
  verification::SharedProblem part = body.problem;
  part.gravityMPerS2 *= state.share;
  for (NodeConstraint& c : part.body.constraints) c.valuesMm *= state.share;
  const Points alone = verification::solveWithCalculix(part, *calculix, folder / "part");
  // Two roads to the same state, each ended at half a hundredth of the residual: 0.05 mm of 23.
  EXPECT_LT((alone - state.displacements).rowwise().norm().maxCoeff(), 0.05);
}

TEST(TruthTargets, AreEvenOverTheVolumeWhateverTheElements) {
  TetrahedralMesh mesh = test::blockMesh(kSize, {8, 2, 2});
  for (Index n = 0; n < mesh.nodes(); ++n)  // slices from 0.9 mm to 14 mm thick
    mesh.points(n, 0) *= mesh.points(n, 0) / kSize.x();
  constexpr int kCount = 4000;
  const TruthTargets targets = drawTargets(mesh, Points::Zero(mesh.nodes(), 3), kCount, 1);
  EXPECT_EQ(targets.preop, targets.moved);
  for (int axis = 0; axis < 3; ++axis) {
    // Four standard errors of the mean of an even distribution, and of its second moment.
    const double length = kSize[axis];
    EXPECT_NEAR(targets.preop.col(axis).mean(), length / 2, 4 * length / std::sqrt(12.0 * kCount));
    EXPECT_NEAR(targets.preop.col(axis).squaredNorm() / kCount, length * length / 3,
                4 * length * length * std::sqrt(4.0 / 45 / kCount));
    EXPECT_GE(targets.preop.col(axis).minCoeff(), 0);
    EXPECT_LE(targets.preop.col(axis).maxCoeff(), length);
  }
}

}  // namespace
}  // namespace falciform::bench
