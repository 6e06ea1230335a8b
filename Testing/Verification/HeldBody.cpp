#include "Testing/Verification/HeldBody.h"

#include "Logic/Biomechanics/ConstrainedStiffness.h"

namespace falciform::verification {

HeldBody heldBody(const TetrahedralMesh& mesh, const Material& material,
                  const std::vector<Support>& supports) {
  const BoundaryFaces faces = boundaryFaces(mesh);
  HeldBody body{.mesh = mesh,
                .materials = {material},
                .constraints = nodeConstraints(faces, nodeNormals(faces, mesh.nodes()), supports),
                .forces = Points::Zero(mesh.nodes(), 3)};
  checkHeld(mesh, body.constraints, faces, supports);
  return body;
}

BodyAnswer solve(const HeldBody& body) {
  const ConstrainedStiffness solver(assembleStiffness(body.mesh, body.materials), body.constraints);
  BodyAnswer answer{.displacements = solver.solve(body.forces), .reactions = {}};
  answer.reactions = solver.reactions(answer.displacements, body.forces);
  return answer;
}

}  // namespace falciform::verification
