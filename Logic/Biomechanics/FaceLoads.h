#pragma once
#include <vector>

#include "Logic/Biomechanics/BoundaryFaces.h"

namespace falciform {

/// Nodal forces of a pressure on boundary faces, N (N x 3): the integral of -p N_i n, for `pressureMPa` that
/// presses into the solid where it is above 0. Exact, since faces are plane. Face numbers may repeat: the
/// pressure then acts as often. Throws InputError for a face that is not there or a pressure that is not
/// finite.
[[nodiscard]] Points pressureForces(const TetrahedralMesh& mesh, const BoundaryFaces& faces,
                                    const std::vector<int>& faceNumbers, double pressureMPa);

/// The same for a force by area that has one direction everywhere, MPa in the mesh's frame.
[[nodiscard]] Points tractionForces(const TetrahedralMesh& mesh, const BoundaryFaces& faces,
                                    const std::vector<int>& faceNumbers, const Vector3d& tractionMPa);

}  // namespace falciform
