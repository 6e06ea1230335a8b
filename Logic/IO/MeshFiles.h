#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "Logic/Core/TetrahedralMesh.h"
#include "Logic/IO/Loaded.h"
#include "Logic/IO/OutputFile.h"

namespace falciform {

/// Reads a tetrahedral mesh from VTU: linear or quadratic tetrahedra, all of one kind; regions from the cell
/// array `Region` (0 where there is none). Cells of other kinds and points of no tetrahedron are left out,
/// with a warning. Space tag and units as readSurface. Throws InputError for a missing, truncated or damaged
/// file, one without tetrahedra, and inverted ones.
[[nodiscard]] Loaded<TetrahedralMesh> readMesh(const std::filesystem::path& file);

/// What a result says of a mesh, by name with the unit in it; written beside `Region`, not read back.
struct MeshArrays {
  std::map<std::string, VectorXd> cells;  ///< one value an element
  std::map<std::string, Points> nodes;    ///< one vector a node
  bool mayBeFolded = false;               ///< a deformed mesh: elements may be turned inside out
};

/// Writes VTU with `Region` and the space tag; written whole or not at all. Throws InputError for another
/// extension, for a damaged mesh and for arrays of another length.
void writeMesh(const std::filesystem::path& file, const TetrahedralMesh& mesh, Overwrite overwrite,
               const MeshArrays& arrays = {});

}  // namespace falciform
