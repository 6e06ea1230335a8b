#pragma once
#include <array>
#include <functional>

#include "Logic/Core/Volume.h"

namespace falciform::test {

/// Label 1 where `inside` says so of a voxel's centre, LPS mm.
[[nodiscard]] LabelMap labelWhere(const Vector3i& size, const Matrix4d& worldFromIndex,
                                  const std::function<bool(const Vector3d&)>& inside);
/// The same by voxel index.
[[nodiscard]] LabelMap labelAt(const Vector3i& size, double spacingMm,
                               const std::function<bool(const Vector3i&)>& inside);
[[nodiscard]] Matrix4d gridAxes(const Matrix3d& axes, const Vector3d& origin = Vector3d::Zero());
/// The same volume stored with new axis a running along old axis `order[a]`, backwards where `flip[a]`.
[[nodiscard]] LabelMap stored(const LabelMap& map, const std::array<int, 3>& order,
                              const std::array<bool, 3>& flip);
/// A lumpy asymmetric organ about 160 mm long around the origin, as a test of a point.
[[nodiscard]] bool insideOrgan(const Vector3d& x);

}  // namespace falciform::test
