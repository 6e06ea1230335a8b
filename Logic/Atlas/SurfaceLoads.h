#pragma once
#include <vector>

#include "Logic/Biomechanics/Material.h"
#include "Logic/Core/Progress.h"
#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// Where unknown hands, packs and supports may press: patches of load spread evenly over the whole surface,
/// each along x, y and z.
struct SurfaceLoadPlan {
  int centres = 120;     ///< three loads each
  double radiusMm = 18;  ///< of a load: it falls off as exp(-r^2 / (2 radius^2))
};

/// How a liver that floats free answers to loads on its surface, each balanced by an even pull on the whole
/// body, with no rigid motion in the answer: a basis for whatever holds and pushes it, since supports, packs
/// and retractors all act through the surface (compare the control points of Heiselman et al. 2020, which
/// displace instead of load).
struct LoadResponses {
  TetrahedralMesh mesh;
  Points centres;  ///< C x 3, mm
  Eigen::MatrixXf
      responses;   ///< 3 C x 3 N: load 3 c + d (centre c along axis d), at node n's axis a in column 3 n + a
  VectorXd rmsMm;  ///< 3 C: over the volume

  [[nodiscard]] Index loads() const { return responses.rows(); }
};

/// Displacements are in no particular unit: only their ratios between loads mean something. Throws InputError
/// for a damaged mesh or material.
[[nodiscard]] LoadResponses solveSurfaceLoads(const TetrahedralMesh& mesh,
                                              const std::vector<Material>& materials,
                                              const SurfaceLoadPlan& plan = {},
                                              const Progress& progress = {});

}  // namespace falciform
