#include <gtest/gtest.h>

#include <numbers>

#include "Logic/Biomechanics/ConstrainedStiffness.h"
#include "Logic/Biomechanics/CorotationalWarp.h"
#include "Logic/Biomechanics/DeformationCheck.h"
#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Testing/Support/BlockMesh.h"

namespace falciform::test {
namespace {

TetrahedralMesh bar() { return quadraticMesh(shakenBlockMesh({100, 10, 10}, {20, 2, 2}, 0.15, 3)); }

TEST(CorotationalWarp, LinearisedTurnBecomesATrueOne) {
  const TetrahedralMesh mesh = bar();
  const Vector3d turn(0.3, -0.5, 0.8);  // about one radian: the linear field swells the bar by half
  Points linear(mesh.nodes(), 3), expected(mesh.nodes(), 3);
  const Matrix3d rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  for (Index n = 0; n < mesh.nodes(); ++n) {
    const Vector3d x = mesh.points.row(n).transpose();
    linear.row(n) = turn.cross(x).transpose();
    expected.row(n) = (rotation * x - x).transpose();
  }
  const Points warped = CorotationalWarp(mesh, {}).apply(linear);
  // The same up to the shift, which keeps the mean of the linear field.
  const Points difference =
      (warped.rowwise() - warped.colwise().mean()) - (expected.rowwise() - expected.colwise().mean());
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-9);  // mm; rounding on 100 mm
}

TEST(CorotationalWarp, SmallStrainsAreLeftAlone) {
  const TetrahedralMesh mesh = bar();
  Points linear(mesh.nodes(), 3);
  for (Index n = 0; n < mesh.nodes(); ++n)
    linear.row(n) << 1e-6 * mesh.points(n, 0) * mesh.points(n, 1), 1e-6 * mesh.points(n, 2), 0;
  const Points warped = CorotationalWarp(mesh, {0}).apply(linear);
  // What is neglected is of second order: gradients of 1e-4 squared, over 100 mm.
  EXPECT_LT((warped - linear).cwiseAbs().maxCoeff(), 2e-6);
}

TEST(CorotationalWarp, BentBarKeepsItsVolumeAndItsLength) {
  const TetrahedralMesh mesh = bar();
  const BoundaryFaces faces = boundaryFaces(mesh);
  Support end{.name = "end"};
  std::vector<int> anchors;
  for (Index f = 0; f < faces.size(); ++f) {
    bool all = true;
    for (int k = 0; k < 3; ++k) all = all && mesh.points(faces.nodes(f, k), 0) < 1e-9;
    if (all) end.faces.push_back(static_cast<int>(f));
  }
  const auto constraints = nodeConstraints(faces, nodeNormals(faces, mesh.nodes()), {end});
  for (const NodeConstraint& constraint : constraints) anchors.push_back(constraint.node);
  const std::vector<Material> soft{Material{}};
  const ConstrainedStiffness solver(assembleStiffness(mesh, soft), constraints);
  Points linear = solver.solve(weightForces(mesh, soft, {0, 0, -9.81}));
  Index tip = 0;
  mesh.points.col(0).maxCoeff(&tip);
  linear *= 60 / linear.row(tip).norm();  // a tip that sags 60 mm of 100
  const auto tipDistance = [&](const Points& u) { return (mesh.points.row(tip) + u.row(tip)).norm(); };
  const auto volume = [&](const Points& u) {
    TetrahedralMesh moved = mesh;
    moved.points += u;
    double sum = 0;
    for (Index e = 0; e < moved.size(); ++e) sum += cornerVolume(moved, e);
    return sum;
  };
  const Points warped = CorotationalWarp(mesh, anchors).apply(linear);
  EXPECT_GT(tipDistance(linear), 110);  // the linear bar grows, about to sqrt(100^2 + 60^2)
  EXPECT_LT(tipDistance(warped), 100);  // a bent bar's end comes nearer
  EXPECT_GT(volume(linear) / volume(Points::Zero(mesh.nodes(), 3)), 1.2);
  EXPECT_NEAR(volume(warped) / volume(Points::Zero(mesh.nodes(), 3)), 1, 0.03);
  EXPECT_GT(checkDeformation(mesh, warped).minDetJ, 0.5);
  for (const int anchor : anchors) EXPECT_EQ(warped.row(anchor), linear.row(anchor));
}

}  // namespace
}  // namespace falciform::test
