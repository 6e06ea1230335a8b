#pragma once
#include "Logic/Core/Types.h"

namespace falciform {

// Small steps of a pose, as a hand makes them. A pose here maps a moving body's frame to the scene's.

/// The body moved on by `step`, mm in the scene.
[[nodiscard]] inline Isometry3d shifted(const Isometry3d& sceneFromBody, const Vector3d& step) {
  Isometry3d moved = sceneFromBody;
  moved.translation() += step;
  return moved;
}

/// The body turned in its place: about the unit `axis` of the scene through where the pose puts
/// `pivotInBody`, which stays there.
[[nodiscard]] inline Isometry3d turned(const Isometry3d& sceneFromBody, const Vector3d& pivotInBody,
                                       const Vector3d& axis, double angleRad) {
  const Vector3d pivot = sceneFromBody * pivotInBody;
  Isometry3d moved = Isometry3d::Identity();
  // Made a rotation again each time: a thousand small steps must not add up to a scaling.
  moved.linear() = Eigen::Quaterniond(Eigen::AngleAxisd(angleRad, axis) * sceneFromBody.linear())
                       .normalized()
                       .toRotationMatrix();
  moved.translation() = pivot - moved.linear() * pivotInBody;
  return moved;
}

}  // namespace falciform
