#pragma once
#include <cstdint>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// A regular grid of voxels, first index fastest. World is patient LPS, mm.
template <class T>
struct Volume {
  Vector3i size = Vector3i::Zero();  ///< voxels along i, j, k
  Matrix4d worldFromIndex =
      Matrix4d::Identity();  ///< LPS mm of a voxel's *centre*; may be oblique or left-handed
  std::vector<T> voxels;     ///< size.prod() values, i fastest

  [[nodiscard]] std::size_t offset(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size.y()) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size.x()) +
           static_cast<std::size_t>(i);
  }
  [[nodiscard]] const T& at(int i, int j, int k) const { return voxels[offset(i, j, k)]; }
  [[nodiscard]] T& at(int i, int j, int k) { return voxels[offset(i, j, k)]; }
  [[nodiscard]] Vector3d world(const Vector3d& index) const {
    return (worldFromIndex * index.homogeneous()).template head<3>();
  }
  [[nodiscard]] Vector3d spacing() const { return worldFromIndex.topLeftCorner<3, 3>().colwise().norm(); }
  [[nodiscard]] double voxelVolume() const {
    return std::abs(worldFromIndex.topLeftCorner<3, 3>().determinant());
  }
};

using LabelMap = Volume<std::uint16_t>;  ///< 0 is background
using Image = Volume<float>;             ///< CT in Hounsfield units
/// Displacements in mm, LPS: what lies at a voxel's centre comes from there plus the vector (the resampling
/// direction).
using DisplacementGrid = Volume<Eigen::Vector3f>;

}  // namespace falciform
