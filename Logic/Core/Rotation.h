#pragma once
#include "Logic/Core/Types.h"

namespace falciform {

/// The rotation by a rotation vector: angle times axis, radians.
[[nodiscard]] inline Matrix3d rotationOf(const Vector3d& turn) {
  const double angle = turn.norm();
  return angle > 0 ? Matrix3d(Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix())
                   : Matrix3d(Matrix3d::Identity());
}

/// The motion that turns about `centre` by a rotation vector and then shifts, mm.
[[nodiscard]] inline Isometry3d motionAbout(const Vector3d& centre, const Vector3d& turn,
                                            const Vector3d& shift) {
  Isometry3d motion = Isometry3d::Identity();
  motion.linear() = rotationOf(turn);
  motion.translation() = centre + shift - motion.linear() * centre;
  return motion;
}

}  // namespace falciform
