#pragma once
#include "Logic/Core/Types.h"

namespace falciform {

// Building blocks of implicit bodies: functions of a point, negative inside, about a distance in mm near
// their surface.

/// Both a and b, their common edge rounded: a true fillet of `radius` mm where the two meet at a right angle.
[[nodiscard]] double roundIntersection(double a, double b, double radius);
/// Either a or b, blended where they differ by less than `blend` mm (cubic polynomial, C2).
[[nodiscard]] double smoothUnion(double a, double b, double blend);
/// a without b, the edge blended over `blend` mm.
[[nodiscard]] double smoothDifference(double a, double b, double blend);
/// 0 below `low`, 1 above `high`, C1 between.
[[nodiscard]] double smoothStep(double low, double high, double value);
/// exp(-value^2 / (2 width^2)).
[[nodiscard]] double bell(double value, double width);

/// A superellipsoid |x/a|^e + |y/b|^e + |z/c|^e = 1 (e = 2: an ellipsoid, larger: boxier) whose lower half
/// may be longer than the upper one, sheared so that its middle rises and swings back from right to left.
struct DomedBody {
  Vector3d centre = Vector3d::Zero();
  Vector3d radii = Vector3d::Ones();  ///< x, y, and z upwards; mm
  double radiusBelow = 1;             ///< z downwards, mm
  double rise = 0;                    ///< mm of z per mm of x
  double sweep = 0;                   ///< mm of y per mm of x
  double exponent = 2;                ///< e, at least 2
  [[nodiscard]] double distance(const Vector3d& p) const;
  /// Lowest and highest corner of a box around it, rows 0 and 1.
  [[nodiscard]] Eigen::Matrix<double, 2, 3> box() const;
};

struct Ellipsoid {
  Vector3d centre = Vector3d::Zero(), radii = Vector3d::Ones();
  [[nodiscard]] double distance(const Vector3d& p) const;
};

/// The hull of two balls, nearly: a segment whose radius changes linearly from `radiusA` to `radiusB`.
struct TaperedCapsule {
  Vector3d a = Vector3d::Zero(), b = Vector3d::Zero();
  double radiusA = 1, radiusB = 1;
  [[nodiscard]] double distance(const Vector3d& p) const;
};

}  // namespace falciform
