#include "Logic/Segmentation/LabelBrush.h"

namespace falciform {

std::vector<std::size_t> voxelsInBall(const LabelMap& grid, const Vector3d& place, double radiusMm) {
  const Matrix4d indexFromWorld = grid.worldFromIndex.inverse();
  const Vector3d middle = (indexFromWorld * place.homogeneous()).head<3>();
  const Vector3i nearest = middle.array().round().cast<int>();
  if ((nearest.array() < 0).any() || (nearest.array() >= grid.size.array()).any()) return {};
  // Along each index the ball reaches as far as the row of the inverse is long.
  const Vector3d reach = radiusMm * indexFromWorld.topLeftCorner<3, 3>().rowwise().norm();
  const Vector3i low = (middle - reach).array().floor().cast<int>().matrix().cwiseMax(0).cwiseMin(nearest),
                 high = (middle + reach)
                            .array()
                            .ceil()
                            .cast<int>()
                            .matrix()
                            .cwiseMin(grid.size - Vector3i::Ones())
                            .cwiseMax(nearest);
  std::vector<std::size_t> found;
  for (int k = low.z(); k <= high.z(); ++k)
    for (int j = low.y(); j <= high.y(); ++j)
      for (int i = low.x(); i <= high.x(); ++i)
        if ((grid.world(Vector3d(i, j, k)) - place).squaredNorm() <= radiusMm * radiusMm ||
            Vector3i(i, j, k) == nearest)
          found.push_back(grid.offset(i, j, k));
  return found;
}

}  // namespace falciform
