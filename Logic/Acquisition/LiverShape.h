#pragma once
#include <array>

#include "Logic/Acquisition/ImplicitBodies.h"
#include "Logic/Acquisition/SyntheticLiver.h"

namespace falciform {

/// The implicit body behind the synthetic liver, LPS mm, x = 0 at the falciform notch: a convex diaphragmatic
/// body cut from below by the visceral surface, a height field z(x, y) with its fissures and impressions.
/// Where the two meet runs the sharp inferior margin. Immutable; any number of threads may ask.
class LiverShape {
 public:
  /// Draws the seed's variation. Settings are taken as checked.
  explicit LiverShape(const SyntheticLiverSettings& settings);

  /// Negative inside; about a distance in mm near the surface.
  [[nodiscard]] double distance(const Vector3d& p) const;
  /// Unit vector outwards near the surface.
  [[nodiscard]] Vector3d normal(const Vector3d& p) const;
  /// Distance to the convex body under diaphragm and abdominal wall, with the falciform groove; negative
  /// inside.
  [[nodiscard]] double diaphragmatic(const Vector3d& p) const;
  /// Distance to the visceral surface; negative above it.
  [[nodiscard]] double visceral(const Vector3d& p) const;

  /// mm from the falciform groove's middle plane, positive to the left.
  [[nodiscard]] double leftOfGroove(const Vector3d& p) const;
  /// 1 where the falciform ligament is attached, along the groove, falling to 0 on the way to the back.
  [[nodiscard]] double grooveStrength(const Vector3d& p) const;
  /// A nominal place (of the liver 210 x 150 x 160 mm) in this liver's coordinates.
  [[nodiscard]] Vector3d place(double x, double y, double z) const;

  /// Corners of a box that holds the body with some air, rows 0 and 1.
  [[nodiscard]] const Eigen::Matrix<double, 2, 3>& bounds() const { return bounds_; }

 private:
  struct Wave {
    Vector3d k = Vector3d::Zero();
    double phase = 0, mm = 0;
  };
  [[nodiscard]] double visceralHeight(double x, double y) const;
  [[nodiscard]] double bumps(const Vector3d& p) const;

  Vector3d scale_ = Vector3d::Ones();
  double rightScale_ = 1, leftScale_ = 1;
  double grooveDepth_, ridgeRadius_, fossaDepth_, tilt_ = 0;
  DomedBody right_, left_;
  std::array<Wave, 6> waves_;
  Eigen::Matrix<double, 2, 3> bounds_;
};

}  // namespace falciform
