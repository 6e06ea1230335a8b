#include <gmock/gmock.h>

#include "Logic/Atlas/AtlasBuilding.h"
#include "Logic/Atlas/ModeCompression.h"
#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Support/RealData.h"

namespace falciform::test {
namespace {

TEST(RealLiver, ThesissPackingsAreInEquilibriumAndTheirModesHoldThem) {
  FALCIFORM_NEEDS_DATA("update/ircad17_left/preop.vtp");
  const Surface preop = readSurface(realData() / "update/ircad17_left/preop.vtp").value;
  MeshSettings settings;
  settings.edgeLengthMm = 12;
  const TetrahedralMesh mesh = meshLiver(preop, {}, settings).mesh;
  ASSERT_GE(3 * mesh.nodes(), 60000);
  const BoundaryFaces faces = boundaryFaces(mesh);
  const AtlasDesign design = atlasPreset("thesis-packing");
  const AtlasJob job = prepareAtlas(mesh, findSupportSites(preop, mesh, faces), design);
  ASSERT_EQ(job.members.members.size(), 180u);
  ASSERT_EQ(job.solves.solves.size(), 20u);
  std::vector<int> batches;
  for (std::size_t b = 0; b < job.solves.batches.size(); ++b) batches.push_back(static_cast<int>(b));
  std::vector<Points> solved;
  solveBatches(mesh, design, job.members, job.solves, batches, [&](int, std::vector<Points> fields) {
    std::move(fields.begin(), fields.end(), std::back_inserter(solved));
  });

  const StiffnessMatrix stiffness = assembleStiffness(mesh, materialsOf(design));
  const NodeNormals normals = nodeNormals(faces, mesh.nodes());
  for (std::size_t k = 0; k < solved.size(); ++k) {
    SCOPED_TRACE(k);
    const std::vector<NodeConstraint> constraints =
        nodeConstraints(faces, normals, job.members.setups[k].supports);
    Points forces = stiffness.times(solved[k]);
    const double most = forces.cwiseAbs().maxCoeff();
    for (const NodeConstraint& c : constraints)
      for (int d = 0; d < c.count; ++d) {
        const Eigen::RowVector3d axis = c.frame.row(d);
        EXPECT_NEAR(axis.dot(solved[k].row(c.node)), c.valuesMm[d], 1e-5);  // mm, single precision
        forces.row(c.node) -= axis.dot(forces.row(c.node)) * axis;
      }
    // What is left acts on nothing: by single precision's rounding of displacements, beside the reactions.
    EXPECT_LT(forces.cwiseAbs().maxCoeff(), 1e-3 * most);
  }

  const Atlas atlas = assembleAtlas(job, solved);
  EXPECT_LE(atlas.rank(), 20);
  EXPECT_GE(atlas.energy, design.energy);
  double left = 0, total = 0;
  const VectorXd& volumes = atlas.nodeVolumesMm3;
  for (Index m = 0; m < 180; ++m) {
    const Points member = fieldOf(solved, job.solves.combinations.row(m));
    left += (member - memberDisplacements(atlas, m)).rowwise().squaredNorm().dot(volumes);
    total += member.rowwise().squaredNorm().dot(volumes);
  }
  EXPECT_LE(left, (1 - design.energy) * total);
}

}  // namespace
}  // namespace falciform::test
