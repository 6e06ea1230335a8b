#pragma once
#include <vector>

#include "Logic/Biomechanics/Supports.h"

namespace falciform::verification {

/// A body, what holds it and what pulls on it: all that a linear problem is.
struct HeldBody {
  TetrahedralMesh mesh;
  std::vector<Material> materials;
  std::vector<NodeConstraint> constraints;  ///< ascending by node
  Points forces;                            ///< nodal, N
};

/// With the constraints of supports on the mesh's outer faces, no force yet.
[[nodiscard]] HeldBody heldBody(const TetrahedralMesh& mesh, const Material& material,
                                const std::vector<Support>& supports);

/// Displacements (mm), and the forces that the supports bear (N), both N x 3.
struct BodyAnswer {
  Points displacements, reactions;
};
[[nodiscard]] BodyAnswer solve(const HeldBody& body);

/// Outer faces whose three corners all lie where `where` says, of a point in mm.
template <class Where>
std::vector<int> facesWhere(const TetrahedralMesh& mesh, const BoundaryFaces& faces, const Where& where) {
  std::vector<int> found;
  for (Index f = 0; f < faces.size(); ++f) {
    bool all = true;
    for (int k = 0; k < 3; ++k) all = all && where(Vector3d(mesh.points.row(faces.nodes(f, k)).transpose()));
    if (all) found.push_back(static_cast<int>(f));
  }
  return found;
}

/// The length of the longest displacement.
[[nodiscard]] inline double largest(const Points& field) { return field.rowwise().norm().maxCoeff(); }

}  // namespace falciform::verification
