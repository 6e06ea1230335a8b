#include "Logic/Segmentation/RegionPieces.h"

#include <algorithm>

namespace falciform {

std::vector<RegionPiece> piecesOf(const Volume<std::uint8_t>& flags) {
  std::vector<std::uint8_t> todo = flags.voxels;
  const Vector3i size = flags.size;
  std::vector<RegionPiece> pieces;
  for (std::size_t first = 0; first < todo.size(); ++first) {
    if (todo[first] == 0) continue;
    RegionPiece piece;
    piece.voxels.push_back(first);
    todo[first] = 0;
    for (std::size_t next = 0; next < piece.voxels.size(); ++next) {
      const auto at = static_cast<int>(piece.voxels[next]);
      const Vector3i here(at % size.x(), at / size.x() % size.y(), at / size.x() / size.y());
      piece.middle += here.cast<double>();
      const Vector3i low = (here - Vector3i::Ones()).cwiseMax(0),
                     high = (here + Vector3i::Ones()).cwiseMin(size - Vector3i::Ones());
      for (int k = low.z(); k <= high.z(); ++k)
        for (int j = low.y(); j <= high.y(); ++j)
          for (int i = low.x(); i <= high.x(); ++i) {
            const std::size_t there = flags.offset(i, j, k);
            if (todo[there] == 0) continue;
            todo[there] = 0;
            piece.voxels.push_back(there);
          }
    }
    std::sort(piece.voxels.begin(), piece.voxels.end());
    piece.middle /= static_cast<double>(piece.voxels.size());
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace falciform
