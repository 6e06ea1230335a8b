#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Logic/Biomechanics/ConstrainedStiffness.h"
#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Logic/Biomechanics/SupportSolver.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Testing/Support/BlockMesh.h"

namespace falciform::test {
namespace {

using ::testing::HasSubstr;

const Vector3d kSize(40, 30, 20);
const std::vector<Material> kLiver{Material{}};

/// Faces of the block whose centre satisfies `where`.
template <class Where>
std::vector<int> facesWhere(const TetrahedralMesh& mesh, const BoundaryFaces& faces, Where where) {
  std::vector<int> found;
  for (Index f = 0; f < faces.size(); ++f) {
    Vector3d centre = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) centre += mesh.points.row(faces.nodes(f, k)).transpose() / 3;
    if (where(centre)) found.push_back(static_cast<int>(f));
  }
  return found;
}

TetrahedralMesh block(bool quadratic) {
  const TetrahedralMesh linear = shakenBlockMesh(kSize, {4, 3, 3}, 0.2, 7);
  return quadratic ? quadraticMesh(linear) : linear;
}

double largest(const Points& field) { return field.rowwise().norm().maxCoeff(); }

class Solver : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Orders, Solver, ::testing::Bool(),
                         [](const auto& order) { return order.param ? "Quadratic" : "Linear"; });

TEST_P(Solver, RigidMotionsCostNothing) {
  const TetrahedralMesh mesh = block(GetParam());
  const StiffnessMatrix stiffness = assembleStiffness(mesh, kLiver);
  const auto motions = rigidMotions(mesh.points);
  for (int m = 0; m < 6; ++m) {
    Points u(mesh.nodes(), 3);
    Eigen::Map<VectorXd>(u.data(), u.size()) = motions.col(m);
    // N, beside blocks of about E times a cell = 0.15 N/mm: rounding only.
    EXPECT_LT(largest(stiffness.times(u)), 1e-14);
  }
}

TEST_P(Solver, PatchTestHoldsToRounding) {
  const TetrahedralMesh mesh = block(GetParam());
  const BoundaryFaces faces = boundaryFaces(mesh);
  // Every boundary node moved by one linear field: the inside must follow it, whatever the mesh.
  Matrix3d gradient;
  gradient << 0.02, -0.01, 0.03, 0.005, -0.015, 0.02, -0.01, 0.01, 0.025;
  std::vector<NodeConstraint> constraints;
  const NodeNormals normals = nodeNormals(faces, mesh.nodes());
  for (Index n = 0; n < mesh.nodes(); ++n)
    if (normals.normals.row(n).squaredNorm() > 0)
      constraints.push_back({.node = static_cast<int>(n),
                             .count = 3,
                             .frame = Matrix3d::Identity(),
                             .valuesMm = gradient * mesh.points.row(n).transpose()});
  const ConstrainedStiffness solver(assembleStiffness(mesh, kLiver), constraints);
  const Points u = solver.solve(Points::Zero(mesh.nodes(), 3));
  EXPECT_LT(largest(u - mesh.points * gradient.transpose()), 1e-10);  // mm, of displacements up to 1.5
}

TEST_P(Solver, SupportReactionsCarryTheWeight) {
  const TetrahedralMesh mesh = block(GetParam());
  const BoundaryFaces faces = boundaryFaces(mesh);
  const std::vector<Support> supports{
      {.name = "bed", .faces = facesWhere(mesh, faces, [](const Vector3d& c) { return c[2] < 1e-9; })}};
  const auto constraints = nodeConstraints(faces, nodeNormals(faces, mesh.nodes()), supports);
  const ConstrainedStiffness solver(assembleStiffness(mesh, kLiver), constraints);
  const Points weight = weightForces(mesh, kLiver, {0, 0, -9.81});
  const double newtons = kSize.prod() * 9.81e-6;  // rho g times volume
  EXPECT_NEAR(weight.col(2).sum(), -newtons, 1e-12);
  const Points u = solver.solve(weight);
  EXPECT_NEAR(solver.reactions(u, weight).col(2).sum(), newtons, 1e-10);
  EXPECT_LT(u.col(2).minCoeff(), 0);  // it sags
}

/// The block on a sliding bed, fixed at one end and pushed from below at the other, gravity turned.
SupportHypothesis packedBlock(const TetrahedralMesh& mesh, const BoundaryFaces& faces) {
  SupportHypothesis hypothesis;
  hypothesis.supports = {
      {.name = "end", .faces = facesWhere(mesh, faces, [](const Vector3d& c) { return c[0] < 1e-9; })},
      {.name = "bed",
       .kind = SupportKind::Sliding,
       .faces = facesWhere(mesh, faces, [](const Vector3d& c) { return c[2] < 1e-9 && c[0] < 20; })},
      {.name = "pack",
       .kind = SupportKind::Pushed,
       .faces = facesWhere(mesh, faces, [](const Vector3d& c) { return c[2] < 1e-9 && c[0] > 30; }),
       .pushMm = 3}};
  hypothesis.gravityChangeMPerS2 = {2, -5, 4};
  return hypothesis;
}

CandidateSupports candidatesOfBlock(const TetrahedralMesh& mesh, const BoundaryFaces& faces) {
  return {.sliding = facesWhere(mesh, faces, [](const Vector3d& c) { return c[2] < 1e-9; }),
          .fixed = facesWhere(mesh, faces, [](const Vector3d& c) { return c[0] < 1e-9; })};
}

TEST_P(Solver, HypothesisEqualsItsOwnFactorisation) {
  const TetrahedralMesh mesh = block(GetParam());
  const BoundaryFaces faces = boundaryFaces(mesh);
  const SupportHypothesis hypothesis = packedBlock(mesh, faces);
  const ConstrainedStiffness direct(
      assembleStiffness(mesh, kLiver),
      nodeConstraints(faces, nodeNormals(faces, mesh.nodes()), hypothesis.supports));
  const Points expected = direct.solve(weightForces(mesh, kLiver, hypothesis.gravityChangeMPerS2));
  const SupportSolver solver(mesh, kLiver, candidatesOfBlock(mesh, faces));
  const Points u = solver.solve(hypothesis);
  EXPECT_LT(largest(u - expected), 1e-5 * largest(expected)) << "of " << largest(expected) << " mm";
}

TEST_P(Solver, SupportsHeldAlwaysGiveTheSameAnswer) {
  const TetrahedralMesh mesh = block(GetParam());
  const BoundaryFaces faces = boundaryFaces(mesh);
  const SupportHypothesis whole = packedBlock(mesh, faces);
  const Points expected = SupportSolver(mesh, kLiver, candidatesOfBlock(mesh, faces)).solve(whole);
  // End and bed held always, the bed being a candidate as well; only the packing is left to the hypothesis.
  CandidateSupports candidates = candidatesOfBlock(mesh, faces);
  candidates.fixed.clear();
  candidates.held = {whole.supports[0], whole.supports[1]};
  const SupportHypothesis packing{.supports = {whole.supports[2]},
                                  .gravityChangeMPerS2 = whole.gravityChangeMPerS2};
  const Points u = SupportSolver(mesh, kLiver, candidates).solve(packing);
  EXPECT_LT(largest(u - expected), 1e-5 * largest(expected));
}

TEST_P(Solver, ManyHypothesesAtOnceEqualEachAlone) {
  const TetrahedralMesh mesh = block(GetParam());
  const BoundaryFaces faces = boundaryFaces(mesh);
  const SupportSolver solver(mesh, kLiver, candidatesOfBlock(mesh, faces));
  std::vector<SupportHypothesis> hypotheses(3, packedBlock(mesh, faces));
  hypotheses[1].supports.back().pushMm = -1;
  hypotheses[2].supports.erase(hypotheses[2].supports.begin() + 1);
  const std::vector<Points> together = solver.solve(hypotheses);
  for (std::size_t h = 0; h < 3; ++h)
    EXPECT_LT(largest(together[h] - solver.solve(hypotheses[h])), 1e-5 * largest(together[h]));
}

TEST_P(Solver, SameBitsForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = block(GetParam());
  const BoundaryFaces faces = boundaryFaces(mesh);
  std::vector<Points> results;
  for (const int count : {1, 2, 3}) {
    setThreads(count);
    results.push_back(
        SupportSolver(mesh, kLiver, candidatesOfBlock(mesh, faces)).solve(packedBlock(mesh, faces)));
  }
  setThreads(0);
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

template <class Call>
std::string messageOf(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Supports, AFreeMotionIsNamed) {
  const TetrahedralMesh mesh = block(false);
  const BoundaryFaces faces = boundaryFaces(mesh);
  const std::vector<Support> bed{
      {.name = "bed", .kind = SupportKind::Sliding, .faces = facesWhere(mesh, faces, [](const Vector3d& c) {
                                                      return c[2] < 1e-9 && c[0] > 5 && c[0] < 35;
                                                    })}};
  const auto constraints = nodeConstraints(faces, nodeNormals(faces, mesh.nodes()), bed);
  EXPECT_THAT(messageOf([&] { checkHeld(mesh.points, constraints, faces, bed); }), HasSubstr("can still"));
}

TEST(Supports, BadMaterialsAreRefusedInOneLine) {
  const TetrahedralMesh mesh = block(false);
  EXPECT_THAT(messageOf([&] { (void)assembleStiffness(mesh, {Material{.youngsModulusMPa = 0}}); }),
              HasSubstr("Young's modulus of region 0 is 0 kPa"));
  EXPECT_THAT(messageOf([&] { (void)assembleStiffness(mesh, {Material{.poissonsRatio = 0.5}}); }),
              HasSubstr("Poisson's ratio of region 0 is 0.5"));
}

}  // namespace
}  // namespace falciform::test
