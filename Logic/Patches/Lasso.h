#pragma once
#include <vector>

#include "Logic/Core/Surface.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {

/// How a surface is looked at, without a window.
struct LassoView {
  /// From mm in the surface's frame to a place on screen: x and y after division by w. Points with w <= 0 lie
  /// behind the viewer.
  Matrix4d screenFromSurface = Matrix4d::Identity();
  Vector3d eye = Vector3d::Zero();  ///< the viewer, mm in the surface's frame; a direction towards him if
  bool parallel = false;            ///< the view has no vanishing point
};

/// Points of `surface` that are seen inside the closed line `outline` (M x 2, on screen, either way round; by
/// the even-odd rule where it crosses itself), ascending. Seen: facing the viewer, and nothing of the surface
/// in front. Points of a cloud hide none; they count if their normal, where there is one, faces the viewer.
/// `tree`, of the same surface, may be nullptr for a cloud only.
[[nodiscard]] std::vector<int> pointsInLasso(const Surface& surface, const Points& normals,
                                             const TriangleTree* tree, const LassoView& view,
                                             const Eigen::Matrix<double, Eigen::Dynamic, 2>& outline);

}  // namespace falciform
