#include "Logic/Biomechanics/MeshPieces.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "Logic/Core/Errors.h"

namespace falciform {

MeshPieces meshPieces(const TetrahedralMesh& mesh) {
  checkMesh(mesh, "the mesh");
  const auto count = static_cast<std::size_t>(mesh.nodes());
  std::vector<int> root(count);
  std::iota(root.begin(), root.end(), 0);
  const auto rootOf = [&](int node) {
    while (root[static_cast<std::size_t>(node)] != node) {  // halves the path for those who come after
      int& up = root[static_cast<std::size_t>(node)];
      up = root[static_cast<std::size_t>(up)];
      node = up;
    }
    return node;
  };
  std::vector<char> used(count, 0);
  for (Index e = 0; e < mesh.size(); ++e)
    for (Index k = 0; k < mesh.elements.cols(); ++k) {
      used[static_cast<std::size_t>(mesh.elements(e, k))] = 1;
      const int a = rootOf(mesh.elements(e, 0)), b = rootOf(mesh.elements(e, k));
      root[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  const auto unused = std::find(used.begin(), used.end(), 0);
  if (unused != used.end())
    throw InputError("node " + std::to_string(unused - used.begin()) +
                     " belongs to no tetrahedron, so that nothing holds it; drop it from the mesh");
  MeshPieces pieces;
  pieces.pieceOf.resize(count);
  for (std::size_t n = 0; n < count; ++n) {
    const int first = rootOf(static_cast<int>(n));  // the smallest of its piece, so already seen
    if (first == static_cast<int>(n)) {
      pieces.pieceOf[n] = static_cast<int>(pieces.nodes.size());
      pieces.nodes.emplace_back();
    }
    pieces.pieceOf[n] = pieces.pieceOf[static_cast<std::size_t>(first)];
    pieces.nodes[static_cast<std::size_t>(pieces.pieceOf[n])].push_back(static_cast<int>(n));
  }
  return pieces;
}

void checkOnePiece(const TetrahedralMesh& mesh) {
  const MeshPieces pieces = meshPieces(mesh);
  if (pieces.nodes.size() == 1) return;
  std::string sizes;
  for (std::size_t p = 0; p < std::min<std::size_t>(pieces.nodes.size(), 3); ++p)
    sizes += (p > 0 ? ", " : "") + std::to_string(pieces.nodes[p].size());
  throw InputError("the mesh is in " + std::to_string(pieces.nodes.size()) + " pieces that do not touch (" +
                   sizes + (pieces.nodes.size() > 3 ? ", ..." : "") +
                   " nodes); keep one of them, or join them and mesh anew");
}

}  // namespace falciform
