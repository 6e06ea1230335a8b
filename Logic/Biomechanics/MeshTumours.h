#pragma once
#include <string>
#include <vector>

#include "Logic/Biomechanics/MeshSettings.h"
#include "Logic/Core/Surface.h"
#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// A piece of a tumour, as it goes into the mesh.
struct TumourPiece {
  int region = 1;
  Surface surface;  ///< remeshed, with its volume kept, if conforming; as given otherwise
  double edgeMm = 0;
  bool conforming = true;  ///< its triangles become faces of elements
};

/// The tumours cut into pieces and remeshed. A piece conforms where it keeps clear of the liver's surface and
/// of the other pieces; the others are left to the elements' centres, with a warning. Throws InputError for a
/// tumour that is no closed surface or lies outside the liver.
[[nodiscard]] std::vector<TumourPiece> tumourPieces(const std::vector<Surface>& tumours, const Surface& liver,
                                                    const MeshSettings& settings,
                                                    std::vector<std::string>& warnings);

/// Nodes that make the mesh finer inside the pieces that do not conform.
[[nodiscard]] Points refiningPoints(const std::vector<TumourPiece>& pieces, const Surface& liver);

/// Region of each element: that of the smallest piece which its centre is inside, or 0.
[[nodiscard]] std::vector<int> regionsOf(const TetrahedralMesh& mesh, const std::vector<TumourPiece>& pieces);

}  // namespace falciform
