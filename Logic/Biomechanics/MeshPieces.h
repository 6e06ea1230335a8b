#pragma once
#include <vector>

#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// Parts of a mesh that share no node, so that no force passes from one to another.
struct MeshPieces {
  std::vector<int> pieceOf;             ///< of each node
  std::vector<std::vector<int>> nodes;  ///< of each piece, ascending; pieces in order of their first node
};

/// Throws InputError for a damaged mesh, or one with a node that no tetrahedron uses: nothing holds that.
[[nodiscard]] MeshPieces meshPieces(const TetrahedralMesh& mesh);

/// Throws InputError for a mesh of more than one piece, saying and how large they are.
void checkOnePiece(const TetrahedralMesh& mesh);

}  // namespace falciform
