#pragma once
#include <algorithm>
#include <array>

#include "Logic/Core/Volume.h"

namespace falciform {

/// A volume asked at places in its own voxel coordinates. The nearest voxel's value; `background` beyond.
template <class T>
struct NearestVoxel {
  const Volume<T>& volume;
  [[nodiscard]] T operator()(const Vector3d& index, T background) const {
    const Vector3d whole = (index.array() + 0.5).floor();
    if (!((whole.array() >= 0).all() && (whole.array() < volume.size.array().template cast<double>()).all()))
      return background;
    return volume.at(static_cast<int>(whole.x()), static_cast<int>(whole.y()), static_cast<int>(whole.z()));
  }
};

/// Up to half a voxel beyond the outer centres the outer values go on: voxels are boxes, not points.
struct TrilinearVoxels {
  const Image& volume;
  [[nodiscard]] float operator()(const Vector3d& index, float background) const {
    std::array<int, 3> low{}, high{};
    std::array<float, 3> t{};
    for (int a = 0; a < 3; ++a) {
      const double last = volume.size[a] - 1;
      if (!(index[a] >= -0.5 && index[a] <= last + 0.5)) return background;
      const double at = std::clamp(index[a], 0.0, last);
      const auto k = static_cast<std::size_t>(a);
      low[k] = std::min(static_cast<int>(at), std::max(0, volume.size[a] - 2));
      high[k] = std::min(low[k] + 1, volume.size[a] - 1);
      t[k] = static_cast<float>(at - low[k]);
    }
    const auto row = [&](int j, int k) {
      const float* values = &volume.voxels[volume.offset(0, j, k)];
      return values[low[0]] + t[0] * (values[high[0]] - values[low[0]]);
    };
    const float near = row(low[1], low[2]) + t[1] * (row(high[1], low[2]) - row(low[1], low[2]));
    const float far = row(low[1], high[2]) + t[1] * (row(high[1], high[2]) - row(low[1], high[2]));
    return near + t[2] * (far - near);
  }
};

/// Trilinear in the grid's voxel coordinates; beyond its border as at the border.
[[nodiscard]] inline Vector3d displacementAt(const DisplacementGrid& grid, const Vector3d& index) {
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
