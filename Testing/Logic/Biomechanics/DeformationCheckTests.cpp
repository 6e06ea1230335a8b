#include <gtest/gtest.h>

#include "Logic/Biomechanics/DeformationCheck.h"
#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Testing/Support/BlockMesh.h"

namespace falciform::test {
namespace {

const Vector3d kSize(40, 30, 20);

TetrahedralMesh block() { return quadraticMesh(shakenBlockMesh(kSize, {8, 6, 6}, 0.2, 7)); }

TEST(DeformationCheck, OfALinearFieldIsItsDeterminantEverywhere) {
  const TetrahedralMesh mesh = block();
  Matrix3d gradient;
  gradient << 0.3, -0.1, 0.2, 0.05, -0.4, 0.1, -0.2, 0.3, 0.25;
  const DeformationCheck check = checkDeformation(mesh, mesh.points * gradient.transpose());
  EXPECT_NEAR(check.minDetJ, (Matrix3d::Identity() + gradient).determinant(), 1e-12);
  EXPECT_EQ(check.foldedShare, 0);
  const DeformationCheck mirrored = checkDeformation(mesh, mesh.points * -2.0);
  EXPECT_NEAR(mirrored.minDetJ, -1, 1e-12);
  EXPECT_NEAR(mirrored.foldedShare, 1, 1e-12);
}

TEST(DeformationCheck, FindsThePlaceWhereAQuadraticFieldFolds) {
  const TetrahedralMesh mesh = block();
  // u_x = -x^2 / 50 mm: det = 1 - x / 25, which is 0 at x = 25 and least, -0.6, at the far face's corners.
  Points u = Points::Zero(mesh.nodes(), 3);
  u.col(0) = mesh.points.col(0).cwiseAbs2() / -50;
  const DeformationCheck check = checkDeformation(mesh, u);
  EXPECT_NEAR(check.minDetJ, 1 - kSize[0] / 25, 1e-12);
  // By places in elements of 5 mm: the fold's border is known to a fraction of one.
  EXPECT_NEAR(check.foldedShare, 15.0 / 40, 0.02);
  double far = 0;
  for (int k = 0; k < 4; ++k) far = std::max(far, mesh.points(mesh.elements(check.worstElement, k), 0));
  EXPECT_EQ(far, kSize[0]);
}

TEST(DeformationCheck, OfEachElementIsThatOfTheMeshCutOutThere) {
  const TetrahedralMesh mesh = block();
  Points u = Points::Zero(mesh.nodes(), 3);
  u.col(0) = mesh.points.col(0).cwiseAbs2() / -50;
  const VectorXd least = leastDetJ(mesh, u);
  ASSERT_EQ(least.size(), mesh.size());
  const DeformationCheck all = checkDeformation(mesh, u);
  EXPECT_EQ(least.minCoeff(), all.minDetJ);
  EXPECT_EQ(least[all.worstElement], all.minDetJ);
  for (Index e = 0; e < mesh.size(); e += 37) {
    // det = 1 - x / 25 falls with x: least at the corner that is farthest along.
    double far = 0;
    for (int k = 0; k < 4; ++k) far = std::max(far, mesh.points(mesh.elements(e, k), 0));
    EXPECT_NEAR(least[e], 1 - far / 25, 1e-12);
  }
}

TEST(DeformationCheck, OfSumsIsThatOfTheirFields) {
  const TetrahedralMesh mesh = block();
  std::vector<Points> fields(3, Points(mesh.nodes(), 3));
  for (Index n = 0; n < mesh.nodes(); ++n) {
    const Vector3d p = mesh.points.row(n).transpose();
    fields[0].row(n) << 0.01 * p[0] * p[1], 0.1 * p[2], 0;
    fields[1].row(n) << 0, 0.02 * p[1] * p[1], 0.3 * p[0];
    fields[2].row(n) << std::sin(p[2] / 5), 0, 0.4 * std::cos(p[0] / 3);
  }
  const std::vector<FieldSum> sums{{{0, 1.0}}, {{0, -0.5}, {2, 3.0}}, {{1, 2.0}, {0, 1.5}, {2, -1.0}}, {}};
  setThreads(1);
  const auto one = checkDeformations(mesh, fields, sums);
  setThreads(3);
  const auto three = checkDeformations(mesh, fields, sums);
  setThreads(0);
  for (std::size_t s = 0; s < sums.size(); ++s) {
    Points total = Points::Zero(mesh.nodes(), 3);
    for (const auto& [field, factor] : sums[s]) total += factor * fields[static_cast<std::size_t>(field)];
    const DeformationCheck alone = checkDeformation(mesh, total);
    EXPECT_NEAR(one[s].minDetJ, alone.minDetJ, 1e-12 + 1e-12 * std::abs(alone.minDetJ));
    EXPECT_NEAR(one[s].foldedShare, alone.foldedShare, 1e-9);
    EXPECT_EQ(one[s].minDetJ, three[s].minDetJ);
    EXPECT_EQ(one[s].foldedShare, three[s].foldedShare);
    EXPECT_EQ(one[s].worstElement, three[s].worstElement);
  }
  EXPECT_EQ(one[3].minDetJ, 1);
}

TEST(DeformationCheck, RefusesAFieldOfAnotherMesh) {
  EXPECT_THROW((void)checkDeformation(block(), Points::Zero(5, 3)), InputError);
}

}  // namespace
}  // namespace falciform::test
