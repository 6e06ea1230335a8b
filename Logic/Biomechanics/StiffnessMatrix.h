#pragma once
#include <vector>

#include "Logic/Biomechanics/Material.h"
#include "Logic/Core/Progress.h"
#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// Which nodes share an element: for node i its neighbours, itself among them, ascending, in
/// neighbours[begin[i]] to neighbours[begin[i + 1]].
struct NodeGraph {
  std::vector<std::size_t> begin;
  std::vector<int> neighbours;

  [[nodiscard]] Index nodes() const { return static_cast<Index>(begin.size()) - 1; }
};

[[nodiscard]] NodeGraph nodeGraph(const TetrahedralMesh& mesh);

/// The stiffness matrix K of Eq. (V.7), in N/mm: the 3 x 3 blocks K_ij of nodes i and j >= i that share an
/// element, in the graph's order. Symmetric; K_ji is K_ij transposed. Without supports its kernel is the six
/// rigid motions.
struct StiffnessMatrix {
  NodeGraph graph;
  std::vector<Matrix3d>
      blocks;  ///< one for each entry of graph.neighbours; those with j < i are zero, unused

  /// The block of nodes i <= j, which must share an element.
  [[nodiscard]] Matrix3d& blockOf(int i, int j);
  /// K u for nodal displacements (N x 3, mm): nodal forces, N.
  [[nodiscard]] Points times(const Points& displacements) const;
};

/// Assembled from straight-edged T4 or T10 elements with the exact quadrature, Galerkin, Eq. (V.1) to (V.7).
/// Same bits for any number of threads. Throws InputError for a damaged mesh or material.
[[nodiscard]] StiffnessMatrix assembleStiffness(const TetrahedralMesh& mesh,
                                                const std::vector<Material>& materials,
                                                const Progress& progress = {});

/// Nodal forces of weight, N (N x 3): the integral of N_i rho g, for an acceleration in m/s2. Force by unit
/// volume pulls along g: Eq. (V.1) with the sign of the errata (B = -rho g).
[[nodiscard]] Points weightForces(const TetrahedralMesh& mesh, const std::vector<Material>& materials,
                                  const Vector3d& accelerationMPerS2);

/// The volume that each node stands for, mm3: its elements' volumes shared out evenly, always above 0, for
/// mass- weighted means over the solid. They sum to the mesh's volume.
[[nodiscard]] VectorXd nodalVolumes(const TetrahedralMesh& mesh);

}  // namespace falciform
