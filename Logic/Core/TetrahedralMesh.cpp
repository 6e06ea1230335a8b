#include "Logic/Core/TetrahedralMesh.h"

#include "Logic/Core/Errors.h"

namespace falciform {

double cornerVolume(const TetrahedralMesh& mesh, Index e) {
  const auto corner = [&](int k) { return Vector3d(mesh.points.row(mesh.elements(e, k)).transpose()); };
  const Vector3d a = corner(0);
  return (corner(1) - a).cross(corner(2) - a).dot(corner(3) - a) / 6;
}

void checkMesh(const TetrahedralMesh& mesh, const std::string& what, bool mayBeFolded) {
  if (mesh.size() == 0 || mesh.nodes() == 0)
    throw InputError(what + " holds no tetrahedra; give a mesh of a solid");
  if (mesh.elements.cols() != 4 && mesh.elements.cols() != 10)
    throw InputError(what + " has elements of " + std::to_string(mesh.elements.cols()) +
                     " nodes; tetrahedra have 4 or 10");
  if (!mesh.points.allFinite()) throw InputError(what + " has coordinates that are not finite numbers");
  if (mesh.elements.minCoeff() < 0 || mesh.elements.maxCoeff() >= mesh.nodes())
    throw InputError(
        what + " names node " +
        std::to_string(mesh.elements.minCoeff() < 0 ? mesh.elements.minCoeff() : mesh.elements.maxCoeff()) +
        " but has " + std::to_string(mesh.nodes()) + " nodes (from 0)");
  if (!mesh.regions.empty() && static_cast<Index>(mesh.regions.size()) != mesh.size())
    throw InputError(what + " has " + std::to_string(mesh.regions.size()) + " region numbers for " +
                     std::to_string(mesh.size()) + " tetrahedra");
  for (Index e = 0; e < mesh.size(); ++e) {
    if (mesh.regionOf(e) < 0)
      throw InputError(what + ": tetrahedron " + std::to_string(e) + " has region " +
                       std::to_string(mesh.regionOf(e)) + "; regions count from 0");
    if (!mayBeFolded && !(cornerVolume(mesh, e) > 0))
      throw InputError(what + ": tetrahedron " + std::to_string(e) + " is inverted or flat (volume " +
                       std::to_string(cornerVolume(mesh, e)) + " mm3); mesh the surface anew");
  }
}

}  // namespace falciform
