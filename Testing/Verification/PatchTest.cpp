#include "Testing/Verification/PatchTest.h"

#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Testing/Support/BlockMesh.h"
#include "Testing/Verification/HeldBody.h"

namespace falciform::verification {

double patchTestError(bool quadratic) {
  const TetrahedralMesh linear = test::shakenBlockMesh({40, 30, 20}, {5, 4, 3}, 0.25, 3);
  const TetrahedralMesh mesh = quadratic ? quadraticMesh(linear) : linear;
  Matrix3d gradient;
  gradient << 0.02, -0.01, 0.03, 0.005, -0.015, 0.02, -0.01, 0.01, 0.025;
  const Points expected = mesh.points * gradient.transpose();
  const NodeNormals normals = nodeNormals(boundaryFaces(mesh), mesh.nodes());
  HeldBody body{
      .mesh = mesh, .materials = {Material{}}, .constraints = {}, .forces = Points::Zero(mesh.nodes(), 3)};
  for (Index n = 0; n < mesh.nodes(); ++n)
    if (normals.normals.row(n).squaredNorm() > 0)
      body.constraints.push_back({.node = static_cast<int>(n),
                                  .count = 3,
                                  .frame = Matrix3d::Identity(),
                                  .valuesMm = expected.row(n).transpose()});
  return largest(solve(body).displacements - expected) / largest(expected);
}

}  // namespace falciform::verification
