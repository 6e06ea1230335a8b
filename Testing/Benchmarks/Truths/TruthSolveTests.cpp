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
  // One end 70 mm towards the other, 60 mm away: through it.
  const TruthBody body =
      heldAtEnds([](const Vector3d& p) { return p.x() < 1 ? p : Vector3d(p - Vector3d(70, 0, 0)); });
  const test::TemporaryFolder folder;
  TruthState state;
  try {
    state = solveTruth(body, *calculix, folder.path());
  } catch (const std::runtime_error& refused) {
    EXPECT_NE(std::string(refused.what()).find("share 1.000"), std::string::npos) << refused.what();
    return;
  }
  EXPECT_LT(state.share, 0.9);
  EXPECT_GE(state.minDetJ, 0.1);
  EXPECT_FALSE(state.refused.empty());
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
