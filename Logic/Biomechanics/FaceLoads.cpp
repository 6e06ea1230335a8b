#include "Logic/Biomechanics/FaceLoads.h"

#include <cmath>
#include <string>

#include "Logic/Core/Errors.h"
#include "Logic/Core/NumberText.h"

namespace falciform {
namespace {

/// Shares out over each face's nodes what `forceOf` its area vector says.
template <class ForceOf>
Points faceForces(const TetrahedralMesh& mesh, const BoundaryFaces& faces,
                  const std::vector<int>& faceNumbers, const ForceOf& forceOf) {
  Points forces = Points::Zero(mesh.nodes(), 3);
  for (const int face : faceNumbers) {
    if (face < 0 || face >= faces.size())
      throw InputError("a load names boundary face " + std::to_string(face) + " but the mesh has " +
                       std::to_string(faces.size()) + " (from 0)");
    const Vector3d force = forceOf(Vector3d(faces.areaVectors.row(face).transpose()));
    for (int k = 0; k < faces.nodesPerFace(); ++k)
      forces.row(faces.nodes(face, k)) += faceShare(faces.quadratic, k) * force.transpose();
  }
  return forces;
}

}  // namespace

Points pressureForces(const TetrahedralMesh& mesh, const BoundaryFaces& faces,
                      const std::vector<int>& faceNumbers, double pressureMPa) {
  if (!std::isfinite(pressureMPa))
    throw InputError("the pressure is " + numberText(pressureMPa) + " MPa; give a finite number");
  return faceForces(mesh, faces, faceNumbers,
                    [&](const Vector3d& area) { return Vector3d(-pressureMPa * area); });
}

Points tractionForces(const TetrahedralMesh& mesh, const BoundaryFaces& faces,
                      const std::vector<int>& faceNumbers, const Vector3d& tractionMPa) {
  if (!tractionMPa.allFinite())
    throw InputError("the traction on the surface is no finite number of MPa; give three finite numbers");
  return faceForces(mesh, faces, faceNumbers,
                    [&](const Vector3d& area) { return Vector3d(area.norm() * tractionMPa); });
}

}  // namespace falciform
