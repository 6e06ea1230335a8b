#include "Logic/Segmentation/StorageOrder.h"

#include <algorithm>

namespace falciform {

StorageOrder canonicalOrder(const Vector3i& size, const Matrix4d& worldFromIndex) {
  const Matrix3d axes = worldFromIndex.topLeftCorner<3, 3>().colwise().normalized();
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

  StorageOrder turned;
  Vector3d start = Vector3d::Zero();  // old index of the new first voxel
  const std::array<std::ptrdiff_t, 3> stride{1, size.x(), static_cast<std::ptrdiff_t>(size.x()) * size.y()};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const int old = best[a];
    const bool flipped = axes(axis, old) < 0;
    turned.size[axis] = size[old];
    turned.step[a] = flipped ? -stride[static_cast<std::size_t>(old)] : stride[static_cast<std::size_t>(old)];
    turned.worldFromIndex.col(axis) = (flipped ? -1 : 1) * worldFromIndex.col(old);
    if (flipped) {
      start[old] = size[old] - 1;
      turned.first += stride[static_cast<std::size_t>(old)] * (size[old] - 1);
    }
  }
  turned.worldFromIndex.topRightCorner<3, 1>() = (worldFromIndex * start.homogeneous()).head<3>();
  return turned;
}

}  // namespace falciform
