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

Vector3d displacementAt(const DisplacementGrid& grid, const Vector3d& index) {
  Vector3i low, high;
  Eigen::Vector3f t;
  for (int a = 0; a < 3; ++a) {
    const double at = std::clamp(index[a], 0.0, static_cast<double>(grid.size[a] - 1));
    low[a] = std::min(static_cast<int>(at), std::max(0, grid.size[a] - 2));
    high[a] = std::min(low[a] + 1, grid.size[a] - 1);
    t[a] = static_cast<float>(at - low[a]);
  }
  const auto row = [&](int j, int k) {
    const Eigen::Vector3f &left = grid.at(low[0], j, k), &right = grid.at(high[0], j, k);
    return Eigen::Vector3f(left + t[0] * (right - left));
  };
  const Eigen::Vector3f near = row(low[1], low[2]) * (1 - t[1]) + row(high[1], low[2]) * t[1],
                        far = row(low[1], high[2]) * (1 - t[1]) + row(high[1], high[2]) * t[1];
  return (near + t[2] * (far - near)).cast<double>();
}

}  // namespace falciform
