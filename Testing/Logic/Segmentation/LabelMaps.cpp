#include "Testing/Logic/Segmentation/LabelMaps.h"

#include <cmath>

namespace falciform::test {

LabelMap labelWhere(const Vector3i& size, const Matrix4d& worldFromIndex,
                    const std::function<bool(const Vector3d&)>& inside) {
  LabelMap map;
  map.size = size;
  map.worldFromIndex = worldFromIndex;
  for (int k = 0; k < size.z(); ++k)
    for (int j = 0; j < size.y(); ++j)
      for (int i = 0; i < size.x(); ++i) map.voxels.push_back(inside(map.world(Vector3d(i, j, k))));
  return map;
}

LabelMap labelAt(const Vector3i& size, double spacingMm, const std::function<bool(const Vector3i&)>& inside) {
  LabelMap map;
  map.size = size;
  map.worldFromIndex.diagonal().head<3>().setConstant(spacingMm);
  for (int k = 0; k < size.z(); ++k)
    for (int j = 0; j < size.y(); ++j)
      for (int i = 0; i < size.x(); ++i) map.voxels.push_back(inside({i, j, k}));
  return map;
}

Matrix4d gridAxes(const Matrix3d& axes, const Vector3d& origin) {
  Matrix4d m = Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = axes;
  m.topRightCorner<3, 1>() = origin;
  return m;
}

LabelMap stored(const LabelMap& map, const std::array<int, 3>& order, const std::array<bool, 3>& flip) {
  Matrix4d oldFromNew = Matrix4d::Zero();
  oldFromNew(3, 3) = 1;
  LabelMap other;
  for (int a = 0; a < 3; ++a) {
    const auto s = static_cast<std::size_t>(a);
    other.size[a] = map.size[order[s]];
    oldFromNew(order[s], a) = flip[s] ? -1 : 1;
    oldFromNew(order[s], 3) = flip[s] ? map.size[order[s]] - 1 : 0;
  }
  other.worldFromIndex = map.worldFromIndex * oldFromNew;
  for (int k = 0; k < other.size.z(); ++k)
    for (int j = 0; j < other.size.y(); ++j)
      for (int i = 0; i < other.size.x(); ++i) {
        const Eigen::Vector4i old = oldFromNew.cast<int>() * Eigen::Vector4i(i, j, k, 1);
        other.voxels.push_back(map.at(old.x(), old.y(), old.z()));
      }
  return other;
}

bool insideOrgan(const Vector3d& x) {
  const double lobe = std::pow(x.x() / 80, 2) + std::pow(x.y() / 50, 2) + std::pow(x.z() / 40, 2);
  const double wave =
      0.12 * std::sin(x.x() / 14) * std::cos(x.y() / 11 + 1) + 0.1 * std::sin(x.z() / 9 + x.x() / 30);
  return lobe + wave < 0.9 - 0.15 * x.x() / 80;
}

}  // namespace falciform::test
