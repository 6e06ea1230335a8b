#include <gtest/gtest.h>

#include "Logic/Biomechanics/ConstrainedStiffness.h"
#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Modules/Distributed/DistributedSolver.h"
#include "Testing/Distributed/PackedLiver.h"
#include "Testing/Support/BlockMesh.h"

namespace falciform::distributed {
namespace {

using test::PackedLiver;

const Ranks& ranks() {
  static const Ranks all;
  return all;
}

/// The largest difference from the direct solution, by that solution's largest displacement; 0 on other
/// ranks.
double differenceFromElimination(const TetrahedralMesh& mesh, const std::vector<Material>& materials,
                                 const std::vector<NodeConstraint>& constraints, const Points& forces,
                                 double scale) {
  const NodeShares shares = shareNodes(mesh.points, ranks().size());
  DistributedSolver solver(ranks(), mesh, shares, materials, constraints);
  const Points found = solver.solve(forces, scale);
  if (!ranks().first()) {
    EXPECT_EQ(found.size(), 0);
    return 0;
  }
  const ConstrainedStiffness direct(assembleStiffness(mesh, materials), constraints);
  const Points wanted = direct.solve({forces}, {scale}).front();
  return (found - wanted).rowwise().norm().maxCoeff() / wanted.rowwise().norm().maxCoeff();
}

// The residual ends at 1e-10 of the load; the displacements' error is that by the condition of the softest
// motions that the grids leave, some hundreds. Both solvers agree to this share of the largest displacement.
constexpr double kAgreement = 1e-7;

/// A shaken block of both orders and two tissues: one end fixed, one side sliding, a patch of the top pushed.
class HeldBlock : public testing::TestWithParam<bool> {};

TEST_P(HeldBlock, DisplacesAsByElimination) {
  TetrahedralMesh mesh = test::shakenBlockMesh({80, 40, 30}, {12, 6, 5}, 0.2, 3);
  if (GetParam()) mesh = quadraticMesh(mesh);
  mesh.regions.assign(static_cast<std::size_t>(mesh.size()), 0);
  for (std::size_t e = 0; e < mesh.regions.size() / 3; ++e) mesh.regions[e] = 1;
  const std::vector<Material> materials{{.youngsModulusMPa = 0.015, .poissonsRatio = 0.47},
                                        {.youngsModulusMPa = 0.03, .poissonsRatio = 0.45}};
  const BoundaryFaces faces = boundaryFaces(mesh);
  Support fixed{.name = "end", .kind = SupportKind::Fixed},
      sliding{.name = "side", .kind = SupportKind::Sliding},
      pushed{.name = "top", .kind = SupportKind::Pushed, .pushMm = 1};
  for (Index f = 0; f < faces.size(); ++f) {
    const Vector3d centre = (mesh.points.row(faces.nodes(f, 0)) + mesh.points.row(faces.nodes(f, 1)) +
                             mesh.points.row(faces.nodes(f, 2))) /
                            3.0;
    const auto face = static_cast<int>(f);
    if (centre[0] < 1e-9) fixed.faces.push_back(face);
    if (centre[1] < 1e-9) sliding.faces.push_back(face);
    if (centre[2] > 30 - 1e-9 && centre[0] > 50) pushed.faces.push_back(face);
  }
  const std::vector<NodeConstraint> constraints =
      nodeConstraints(faces, nodeNormals(faces, mesh.nodes()), {fixed, sliding, pushed});
  const Points weight = weightForces(mesh, materials, {2, -3, -9});
  EXPECT_LT(differenceFromElimination(mesh, materials, constraints, weight, 4.5), kAgreement);
  EXPECT_LT(differenceFromElimination(mesh, materials, constraints, weight, 0), kAgreement);
}

INSTANTIATE_TEST_SUITE_P(Orders, HeldBlock, testing::Bool(),
                         [](const auto& order) { return order.param ? "Quadratic" : "Linear"; });

TEST(DistributedSolver, PackedLiverDisplacesAsByElimination) {
  const PackedLiver liver(18);
  EXPECT_LT(differenceFromElimination(liver.mesh, liver.materials, liver.constraints,
                                      weightForces(liver.mesh, liver.materials, {0, 0, 4}), 10),
            kAgreement);
}

TEST(DistributedSolver, SaysSoWhenTheIterationEndsTooEarly) {
  const PackedLiver liver(24);
  const NodeShares shares = shareNodes(liver.mesh.points, ranks().size());
  DistributedSolver solver(ranks(), liver.mesh, shares, liver.materials, liver.constraints,
                           {.maxIterations = 2});
  EXPECT_THROW((void)solver.solve(Points::Zero(liver.mesh.nodes(), 3), 1), InputError);
}

TEST(DistributedSolver, EachRankHoldsItsOwnShareOfTheMatrixOnly) {
  const PackedLiver liver(18);
  for (const int count : {1, 2, 3, 8}) {
    const NodeShares shares = shareNodes(liver.mesh.points, count);
    ASSERT_EQ(shares.ranks(), count);
    std::vector<int> owners(static_cast<std::size_t>(liver.mesh.nodes()), 0);
    for (int r = 0; r < count; ++r) {
      const int size =
          shares.begin[static_cast<std::size_t>(r) + 1] - shares.begin[static_cast<std::size_t>(r)];
      EXPECT_NEAR(size, static_cast<double>(liver.mesh.nodes()) / count, 3);  // a node a cut, three cuts
      for (int k = 0; k < size; ++k)
        ++owners[static_cast<std::size_t>(
            shares.nodes[static_cast<std::size_t>(shares.begin[static_cast<std::size_t>(r)] + k)])];
    }
    EXPECT_EQ(owners, std::vector<int>(owners.size(), 1));
  }
}

TEST(DistributedSolver, RowsOfOwnElementsAreTheWholesRows) {
  const PackedLiver liver(24);
  const StiffnessMatrix whole = assembleStiffness(liver.mesh, liver.materials);
  Points field = liver.mesh.points;  // any field that is no rigid motion
  field.col(0).array() *= field.col(1).array();
  const Points wanted = whole.times(field);
  const NodeShares shares = shareNodes(liver.mesh.points, 3);
  for (int r = 0; r < 3; ++r) {
    const OwnElements own = ownElements(liver.mesh, shares, r);
    EXPECT_LT(own.mesh.size(), liver.mesh.size());
    Points part(own.mesh.nodes(), 3);
    for (Index n = 0; n < part.rows(); ++n) part.row(n) = field.row(own.nodes[static_cast<std::size_t>(n)]);
    const Points found = assembleStiffness(own.mesh, liver.materials).times(part);
    double largest = 0;
    for (int p = shares.begin[static_cast<std::size_t>(r)]; p < shares.begin[static_cast<std::size_t>(r) + 1];
         ++p) {
      const int node = shares.nodes[static_cast<std::size_t>(p)];
      largest = std::max(largest, (found.row(own.at(node)) - wanted.row(node)).norm());
    }
    EXPECT_LT(largest, 1e-12 * wanted.cwiseAbs().maxCoeff());  // rounding of sums in another order
  }
}

}  // namespace
}  // namespace falciform::distributed

int main(int count, char** values) {
  (void)falciform::distributed::ranks();
  testing::InitGoogleTest(&count, values);
  return RUN_ALL_TESTS();
}
