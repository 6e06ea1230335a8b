#include <gtest/gtest.h>

#include "Logic/Biomechanics/CornerWarp.h"
#include "Logic/Biomechanics/CorotationalWarp.h"
#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Logic/Core/Rotation.h"
#include "Testing/Support/BlockMesh.h"

namespace falciform::test {
namespace {

TetrahedralMesh linearBar() { return shakenBlockMesh({100, 10, 10}, {20, 2, 2}, 0.15, 3); }

/// Displacements that twist and bend, rigid motion and all: gradients up to 0.3.
Points bending(const TetrahedralMesh& mesh) {
  Points linear(mesh.nodes(), 3);
  for (Index n = 0; n < mesh.nodes(); ++n) {
    const Vector3d x = mesh.points.row(n).transpose() / 100;
    linear.row(n) << 3 * x.z() * x.x(), 10 * x.x() * x.x(), -15 * x.x() * x.x() + 2 * x.y();
  }
  return linear;
}

TEST(CornerWarp, OnLinearTetrahedraItIsTheCorotationalWarp) {
  const TetrahedralMesh mesh = linearBar();
  const Points linear = bending(mesh);
  const Points expected = CorotationalWarp(mesh, {}).apply(linear);
  const Points warped = linear + CornerWarp(mesh).apply(linear).added;
  EXPECT_LT((warped - expected).cwiseAbs().maxCoeff(), 1e-12);  // mm; the same sums but for the last one
}

TEST(CornerWarp, LinearisedTurnBecomesATrueOneAndIsTold) {
  const TetrahedralMesh mesh = quadraticMesh(linearBar());
  const Vector3d turn(0.3, -0.5, 0.8);  // about one radian
  Points linear(mesh.nodes(), 3);
  for (Index n = 0; n < mesh.nodes(); ++n)
    linear.row(n) = turn.cross(Vector3d(mesh.points.row(n).transpose())).transpose();
  const CornerWarp::Change change = CornerWarp(mesh).apply(linear);
  const Points turned = mesh.points + linear + change.added;
  const Points expected = mesh.points * rotationOf(turn).transpose();
  const Points difference =
      (turned.rowwise() - turned.colwise().mean()) - (expected.rowwise() - expected.colwise().mean());
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-9);  // mm; rounding on 100 mm
  EXPECT_LT((change.turns.rowwise() - turn.transpose()).cwiseAbs().maxCoeff(), 1e-12);  // radians
}

TEST(CornerWarp, QuadraticMeshesFollowTheirCorners) {
  const TetrahedralMesh linearMesh = linearBar(), mesh = quadraticMesh(linearMesh);
  const Points whole = CorotationalWarp(mesh, {}).apply(bending(mesh));
  const Points warped = bending(mesh) + CornerWarp(mesh).apply(bending(mesh)).added;
  // Beside the quadratic warp: what remains is what linear elements of 5 mm leave of a correction of 7 mm.
  const Points difference =
      (warped.rowwise() - warped.colwise().mean()) - (whole.rowwise() - whole.colwise().mean());
  const double correction = (whole - bending(mesh)).rowwise().norm().maxCoeff();
  EXPECT_GT(correction, 1);
  EXPECT_LT(difference.rowwise().norm().maxCoeff(), 0.05 * correction);
}

TEST(CornerWarp, NoTurnIsTheIdentity) {
  EXPECT_EQ(rotationOf(Vector3d::Zero()), Matrix3d(Matrix3d::Identity()));
  EXPECT_NEAR(rotationOf({0, 0, 0.5})(1, 0), std::sin(0.5), 1e-15);  // about z: x turns towards y
}

}  // namespace
}  // namespace falciform::test
