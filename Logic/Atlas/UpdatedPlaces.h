#pragma once
#include "Logic/Atlas/ModelUpdate.h"

namespace falciform {

/// Pre-op places (K x 3, mm) to where an update by any method says they are now, scan mm: the displacements
/// of `mesh`'s nodes, then the rigid part. Beyond the mesh displacements go on linearly. Throws InputError
/// where the update is of another mesh.
[[nodiscard]] Points scanFromPreop(const TetrahedralMesh& mesh, const UpdateResult& update,
                                   const Points& preopMm);

}  // namespace falciform
