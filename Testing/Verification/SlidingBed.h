#pragma once
#include "Testing/Verification/HeldBody.h"

namespace falciform::verification {

/// A block on a bed that it may slide on, under oblique gravity, one end fixed; a rigid motion is applied to
/// the whole problem.
struct SlidingBed {
  HeldBody body;
  std::vector<NodeConstraint> bed;  ///< those that bind along the bed's normal only
};

/// `wavy`: the bed is curved both ways, so that Engelman's normals differ from node to node; else plane.
[[nodiscard]] SlidingBed slidingBed(bool quadratic, bool wavy, const Matrix3d& rotation,
                                    const Vector3d& translation);

/// A rotation about no axis in particular.
[[nodiscard]] Matrix3d someRotation();

/// What must hold of a frictionless bed, as relative errors.
struct BedErrors {
  double rotated = 0;          ///< answer of the rotated problem against the rotated answer, by the largest
  double intoBed = 0;          ///< largest |u.n| at the bed, by the largest displacement
  double tangentialForce = 0;  ///< largest of the bed's forces along the bed, by the weight
  double balance = 0;          ///< weight and all support forces, by the weight
};
[[nodiscard]] BedErrors bedErrors(bool quadratic, bool wavy);

}  // namespace falciform::verification
