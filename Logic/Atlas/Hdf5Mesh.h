#pragma once
#include "Logic/Atlas/Hdf5Store.h"
#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// A mesh as the group "mesh" of one of our HDF5 files: frame, points_mm, elements, regions.
void writeMeshArrays(Hdf5Writer& file, const TetrahedralMesh& mesh);
/// Throws InputError as Hdf5Reader does, and for a damaged mesh; `what` names the file.
[[nodiscard]] TetrahedralMesh readMeshArrays(const Hdf5Reader& file, const std::string& what);

}  // namespace falciform
