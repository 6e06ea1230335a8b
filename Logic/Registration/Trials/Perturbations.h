#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "Logic/Core/Settings.h"
#include "Logic/Core/Types.h"

namespace falciform {

/// How far a perturbation may turn and shift.
struct TrialScale {
  double rotationDeg = 180;
  double translationMm = 200;
};

template <class Visitor>
void describe(TrialScale& s, Visitor&& field) {
  field(FieldInfo{"rotationDeg", "Rotation", "deg", 0, 180,
                  "Largest angle: of each axis (euler) or of the whole rotation (uniform)."},
        s.rotationDeg);
  field(FieldInfo{"translationMm", "Translation", "mm", 0, 10000, "Largest shift along each axis."},
        s.translationMm);
}

/// The thesis's two scales (ch. III): "small" 45 deg and 50 mm, "large" 180 deg and 200 mm.
inline constexpr TrialScale kSmallScale{45, 50}, kLargeScale{180, 200};

/// How rotations are spread.
enum class TrialDistribution {
  Euler,    ///< the thesis: an angle a axis, each uniform; R = Rz Ry Rx. Not uniform on SO(3)
  Uniform,  ///< uniform on SO(3) (Haar measure) among the rotations by at most the scale's angle
};
inline std::span<const std::string_view> enumNames(TrialDistribution) {
  static constexpr std::array<std::string_view, 2> names{"euler", "uniform"};
  return names;
}

/// The perturbation of one trial: turns about `centre` (mm) and then shifts, each axis uniform. Each trial
/// has its own random numbers from (seed, trial), so it is the same whatever else is drawn.
[[nodiscard]] Isometry3d perturbation(const TrialScale& scale, TrialDistribution distribution,
                                      std::uint64_t seed, std::uint64_t trial, const Vector3d& centre);

/// The angle of a rotation that is uniform on SO(3) among those by at most `most` rad, for u uniform in
/// [0, 1): solves (t - sin t) / (most - sin most) = u.
[[nodiscard]] double uniformRotationAngle(double u, double most);

}  // namespace falciform
