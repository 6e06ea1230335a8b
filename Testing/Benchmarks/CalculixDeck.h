#pragma once
#include <filesystem>

#include "Logic/Biomechanics/Material.h"
#include "Logic/Biomechanics/Supports.h"

namespace falciform::bench {

/// A linear static problem as CalculiX (ccx) reads it: quadratic tetrahedra, one material, nodes held or
/// moved along the axes of their own frames. Writes NAME.inp; asks for the displacements in NAME.dat.
void writeDeck(const std::filesystem::path& file, const TetrahedralMesh& mesh, const Material& material,
               const std::vector<NodeConstraint>& constraints);

/// The displacements that ccx has written: N x 3, mm. Throws std::runtime_error if a node is missing.
[[nodiscard]] Points readDisplacements(const std::filesystem::path& datFile, Index nodes);

}  // namespace falciform::bench
