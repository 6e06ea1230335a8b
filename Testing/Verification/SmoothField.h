#pragma once
#include <array>

#include "Testing/Verification/HeldBody.h"

namespace falciform::verification {

/// A displacement field made up beforehand, a sum of waves a sin(k.x + phase): the body force that it needs
/// is known in closed form, so that a solver has an answer to be measured against on any body.
struct SmoothField {
  struct Wave {
    Vector3d amplitude, number;
    double phase;
  };
  std::array<Wave, 3> waves;
  Material material;

  [[nodiscard]] Vector3d displacement(const Vector3d& x) const;  ///< mm
  [[nodiscard]] Matrix3d gradient(const Vector3d& x) const;      ///< du_i / dx_j
  /// -div sigma(u) = sum of ((lambda + mu) k (k.a) + mu k.k a) sin(k.x + phase), N/mm3.
  [[nodiscard]] Vector3d bodyForce(const Vector3d& x) const;
};

/// Waves of about a body of 30 mm; no symmetry.
[[nodiscard]] SmoothField smoothField(const Material& material);

/// The body under the field's force, every outer node at the field's displacement.
[[nodiscard]] HeldBody bodyUnder(const SmoothField& field, const TetrahedralMesh& mesh);

/// How far an answer is from the field, relative to the field.
struct FieldError {
  double displacement = 0;  ///< in L2 over the volume
  double energy = 0;        ///< in the norm of the strain energy
};
[[nodiscard]] FieldError errorOf(const Points& displacements, const SmoothField& field,
                                 const TetrahedralMesh& mesh);

/// The field's answer on a shaken block of 30 mm a side with `cells` boxes along each.
[[nodiscard]] FieldError smoothFieldError(const Material& material, bool quadratic, int cells);

/// p where errors go as h^p, from two meshes with `coarse` and `fine` cells a side.
[[nodiscard]] double observedOrder(double coarseError, double fineError, int coarse, int fine);

}  // namespace falciform::verification
