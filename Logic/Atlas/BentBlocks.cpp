#include "Logic/Atlas/BentBlocks.h"

#include <algorithm>

namespace falciform {

BentBlocks::BentBlocks(const UpdateMap& map, const SampledGrid& grid) : size_(grid.size) {
  cells_.assign(static_cast<std::size_t>(size_.cast<Index>().prod()), 0);
  const Matrix4d indexFromWorld = grid.worldFromIndex.inverse();
  const Matrix3d turn = indexFromWorld.topLeftCorner<3, 3>();
  for (int e = 0; e < map.deformed().size(); ++e) {
    const Vector3d low = map.deformed().lowest(e), high = map.deformed().highest(e);
    const Vector3d centre = (indexFromWorld * Vector3d((low + high) / 2).homogeneous()).head<3>();
    const Vector3d half = turn.cwiseAbs() * (high - low) / 2;
    const Vector3i from = (centre - half).array().floor().cast<int>().max(0),
                   to = (centre + half).array().floor().cast<int>().min(size_.array() - 1);
    for (int k = from.z(); k <= to.z(); ++k)
      for (int j = from.y(); j <= to.y(); ++j)
        for (int i = from.x(); i <= to.x(); ++i) cells_[offset({i, j, k})] = 1;
  }
}

}  // namespace falciform
