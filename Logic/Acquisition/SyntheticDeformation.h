#pragma once
#include <vector>

#include "Logic/Acquisition/SyntheticLiver.h"

namespace falciform {

/// A soft change of shape as between imaging and operation: smooth, without rigid motion, without divergence
/// (so the volume is nearly kept). Not a mechanical model.
struct SyntheticDeformationSettings {
  double rmsMm = 5;           ///< RMS length of the displacement over the surface's points
  double wavelengthMm = 260;  ///< shortest wavelength; longer is smoother
  int seed = 1;
};

template <class Visitor>
void describe(SyntheticDeformationSettings& s, Visitor&& field) {
  field(FieldInfo{"rmsMm", "Deformation", "mm", 0, 25, "RMS displacement of the surface."}, s.rmsMm);
  field(FieldInfo{"wavelengthMm", "Wavelength", "mm", 100, 1000, "Shortest wavelength of the displacement."},
        s.wavelengthMm);
  field(FieldInfo{"seed", "Seed", "", 0, 2147483647, "Draws the displacement."}, s.seed);
}

/// A displacement field u(p) = sum of a_k sin(k . p + phase) - t - omega x (p - c), mm.
struct SmoothDisplacement {
  struct Mode {
    Vector3d amplitude = Vector3d::Zero(), wave = Vector3d::Zero();
    double phase = 0;
  };
  std::vector<Mode> modes;
  Vector3d translation = Vector3d::Zero(), rotation = Vector3d::Zero(), centre = Vector3d::Zero();

  [[nodiscard]] Vector3d at(const Vector3d& p) const;
  [[nodiscard]] Matrix3d gradient(const Vector3d& p) const;
  /// Each point p moved to p + u(p).
  [[nodiscard]] Points moved(const Points& points) const;
};

/// Draws a field whose best rigid motion over `points` is nil and whose RMS there is `rmsMm`. Throws
/// InputError if it would fold the body (det(I + grad u) < 0.2 at a point), or if there are fewer than three
/// points.
[[nodiscard]] SmoothDisplacement drawDisplacement(const Points& points,
                                                  const SyntheticDeformationSettings& settings);

/// The liver with one such field applied to surface, structures, targets and landmarks alike: all keep their
/// order.
[[nodiscard]] SyntheticLiver deformSynthetic(const SyntheticLiver& liver,
                                             const SyntheticDeformationSettings& settings);

}  // namespace falciform
