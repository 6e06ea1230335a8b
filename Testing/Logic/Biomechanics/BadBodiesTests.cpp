#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Logic/Biomechanics/ConstrainedStiffness.h"
#include "Logic/Biomechanics/MeshPieces.h"
#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Logic/Biomechanics/SupportSolver.h"
#include "Logic/Core/Errors.h"
#include "Testing/Support/BlockMesh.h"
#include "Testing/Verification/HeldBody.h"

namespace falciform::verification {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

template <class Call>
std::string messageOf(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TetrahedralMesh block() { return test::shakenBlockMesh({40, 30, 20}, {4, 3, 3}, 0.2, 7); }

/// Two blocks 100 mm apart in one mesh.
TetrahedralMesh twoBlocks() {
  const TetrahedralMesh one = block();
  TetrahedralMesh both = one;
  both.points.conservativeResize(2 * one.nodes(), 3);
  both.points.bottomRows(one.nodes()) = one.points.rowwise() + Eigen::RowVector3d(100, 0, 0);
  both.elements.conservativeResize(2 * one.size(), 4);
  both.elements.bottomRows(one.size()) = one.elements.array() + static_cast<int>(one.nodes());
  return both;
}

Support endAt(const TetrahedralMesh& mesh, double x) {
  return {.name = "end at " + std::to_string(x),
          .faces = facesWhere(mesh, boundaryFaces(mesh),
                              [x](const Vector3d& p) { return std::abs(p[0] - x) < 1e-9; })};
}

std::string solveMessage(const TetrahedralMesh& mesh, const std::vector<Support>& supports,
                         const Material& material = {}) {
  return messageOf([&] { (void)solve(heldBody(mesh, material, supports)); });
}

TEST(BadBodies, AnInvertedElementIsNamed) {
  TetrahedralMesh mesh = block();
  std::swap(mesh.elements(17, 0), mesh.elements(17, 1));
  EXPECT_THAT(messageOf([&] { (void)assembleStiffness(mesh, {Material{}}); }),
              AllOf(HasSubstr("tetrahedron 17 is inverted or flat"), HasSubstr("mesh the surface anew"),
                    Not(HasSubstr("\n"))));
}

TEST(BadBodies, ADoubledElementIsNamedWhereverItLies) {
  for (Index doubled : {Index{0}, Index{17}, Index{100}}) {
    TetrahedralMesh mesh = block();
    mesh.elements.conservativeResize(mesh.size() + 1, 4);
    mesh.elements.row(mesh.size() - 1) = mesh.elements.row(doubled);
    const std::string message = solveMessage(mesh, {endAt(block(), 0)});
    EXPECT_THAT(message, AllOf(HasSubstr("doubled"), HasSubstr(std::to_string(mesh.size() - 1)),
                               Not(HasSubstr("\n"))));
  }
  TetrahedralMesh alone;
  alone.points.resize(4, 3);
  alone.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  alone.elements.resize(2, 4);
  alone.elements << 0, 1, 2, 3, 1, 2, 0, 3;
  EXPECT_THAT(messageOf([&] { (void)boundaryFaces(alone); }),
              HasSubstr("tetrahedra 0 and 1 lie on the same side of one face"));
}

TEST(BadBodies, ABodyThatNothingHoldsIsRefused) {
  const TetrahedralMesh mesh = block();
  EXPECT_THAT(solveMessage(mesh, {}), AllOf(HasSubstr("do not hold the liver"), Not(HasSubstr("\n"))));
  // The factor itself refuses, with no check before it: rounding leaves tiny pivots of either sign.
  for (const bool quadratic : {false, true})
    EXPECT_THAT(messageOf([&] {
                  ConstrainedStiffness(
                      assembleStiffness(quadratic ? quadraticMesh(mesh) : mesh, {Material{}}), {});
                }),
                AllOf(HasSubstr("do not hold every piece of the mesh"), Not(HasSubstr("\n"))));
}

TEST(BadBodies, APieceThatNothingHoldsIsNamed) {
  const TetrahedralMesh linear = twoBlocks();
  for (const bool quadratic : {false, true}) {
    const TetrahedralMesh mesh = quadratic ? quadraticMesh(linear) : linear;
    EXPECT_THAT(solveMessage(mesh, {endAt(mesh, 0)}),
                AllOf(HasSubstr("do not hold piece 2 of 2 of the mesh"), HasSubstr("around 120, 15, 10 mm"),
                      Not(HasSubstr("\n"))));
    EXPECT_EQ(solveMessage(mesh, {endAt(mesh, 0), endAt(mesh, 100)}), "no error");
    // And no factor comes about where nobody asked.
    const BoundaryFaces faces = boundaryFaces(mesh);
    const auto constraints = nodeConstraints(faces, nodeNormals(faces, mesh.nodes()), {endAt(mesh, 0)});
    EXPECT_THAT(messageOf([&] { ConstrainedStiffness(assembleStiffness(mesh, {Material{}}), constraints); }),
                HasSubstr("do not hold every piece of the mesh"));
    EXPECT_THAT(
        messageOf([&] { SupportSolver(mesh, {Material{}}, {.sliding = {}, .fixed = endAt(mesh, 0).faces}); }),
        AllOf(HasSubstr("in 2 pieces that do not touch"), Not(HasSubstr("\n"))));
  }
}

TEST(BadBodies, ANodeWithoutElementsIsNamed) {
  TetrahedralMesh mesh = block();
  mesh.points.conservativeResize(mesh.nodes() + 1, 3);
  mesh.points.row(mesh.nodes() - 1).setZero();
  EXPECT_THAT(solveMessage(mesh, {endAt(block(), 0)}),
              HasSubstr("node " + std::to_string(mesh.nodes() - 1) + " belongs to no tetrahedron"));
}

TEST(BadBodies, MaterialsThatNoSolidHasAreRefused) {
  const TetrahedralMesh mesh = block();
  const std::vector<Support> end{endAt(mesh, 0)};
  EXPECT_THAT(solveMessage(mesh, end, {.poissonsRatio = 0.5}),
              AllOf(HasSubstr("Poisson's ratio of region 0 is 0.5"), Not(HasSubstr("\n"))));
  for (const double modulus : {0.0, -0.015, std::nan("")})
    EXPECT_THAT(
        solveMessage(mesh, end, {.youngsModulusMPa = modulus}),
        AllOf(HasSubstr("Young's modulus of region 0 is"), HasSubstr("above 0"), Not(HasSubstr("\n"))));
}

TEST(BadBodies, SlenderNearlyIncompressibleOnesAreNotMistakenForThem) {
  // The smallest pivots of bodies that are held: a thin bar held at one end, at nu's limit.
  for (const bool quadratic : {false, true}) {
    const TetrahedralMesh linear = test::blockMesh({400, 5, 5}, {120, 2, 2});
    const TetrahedralMesh mesh = quadratic ? quadraticMesh(linear) : linear;
    EXPECT_EQ(solveMessage(mesh, {endAt(mesh, 0)}, {.poissonsRatio = 0.4999}), "no error");
  }
}

}  // namespace
}  // namespace falciform::verification
