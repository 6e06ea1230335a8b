#include <algorithm>
#include <array>
#include <cmath>

#include "Logic/Segmentation/SurfaceImport.h"

namespace falciform {

std::vector<std::pair<int, std::size_t>> labelCounts(const LabelMap& map) {
  std::vector<std::size_t> counts(65536, 0);
  for (const std::uint16_t value : map.voxels) ++counts[value];
  std::vector<std::pair<int, std::size_t>> found;
  for (int value = 1; value < 65536; ++value)
    if (counts[static_cast<std::size_t>(value)] > 0)
      found.emplace_back(value, counts[static_cast<std::size_t>(value)]);
  return found;
}

LabelMap canonicalAxes(const LabelMap& map) {
  // Which old axis becomes i, j, k: the pairing whose directions agree best with L, P, S in sum, which stays
  // well defined for oblique grids where two axes may lean to the same world axis.
  const Matrix3d axes = map.worldFromIndex.topLeftCorner<3, 3>().colwise().normalized();
  std::array<int, 3> order{0, 1, 2}, best = order;
  double bestSum = -1;
  do {
    double sum = 0;
    for (int world = 0; world < 3; ++world)
      sum += std::abs(axes(world, order[static_cast<std::size_t>(world)]));
    if (sum > bestSum) {
      bestSum = sum;
      best = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));

  LabelMap turned;
  turned.worldFromIndex = map.worldFromIndex;
  Vector3d start = Vector3d::Zero();  // old index of the new first voxel
  std::array<std::ptrdiff_t, 3> step{};
  const std::array<std::ptrdiff_t, 3> stride{1, map.size.x(),
                                             static_cast<std::ptrdiff_t>(map.size.x()) * map.size.y()};
  std::ptrdiff_t first = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const int old = best[a];
    const bool flipped = axes(axis, old) < 0;
    turned.size[axis] = map.size[old];
    step[a] = flipped ? -stride[static_cast<std::size_t>(old)] : stride[static_cast<std::size_t>(old)];
    turned.worldFromIndex.col(axis) = (flipped ? -1 : 1) * map.worldFromIndex.col(old);
    if (flipped) {
      start[old] = map.size[old] - 1;
      first += stride[static_cast<std::size_t>(old)] * (map.size[old] - 1);
    }
  }
  turned.worldFromIndex.topRightCorner<3, 1>() = map.world(start);

  turned.voxels.reserve(map.voxels.size());
  for (int k = 0; k < turned.size.z(); ++k)
    for (int j = 0; j < turned.size.y(); ++j) {
      std::ptrdiff_t from = first + k * step[2] + j * step[1];
      for (int i = 0; i < turned.size.x(); ++i, from += step[0])
        turned.voxels.push_back(map.voxels[static_cast<std::size_t>(from)]);
    }
  return turned;
}

}  // namespace falciform
