#pragma once
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// An isotropic, linearly elastic material, Eq. (V.2) to (V.4). The defaults are those of the thesis's
/// simulations: liver tissue of 15 kPa.
struct Material {
  double youngsModulusMPa = 0.015;  ///< E, above 0
  double poissonsRatio = 0.47;      ///< nu, in (-1, 0.5)
  double densityKgPerM3 = 1000;     ///< rho, 0 or more
};

/// Lamé's constants, MPa, Eq. (V.4).
[[nodiscard]] double shearModulusMPa(const Material& material);
[[nodiscard]] double lameLambdaMPa(const Material& material);

/// Throws InputError for E <= 0, nu outside (-1, 0.4999], or a negative density; `what` names the region.
void checkMaterial(const Material& material, const std::string& what);

/// The material of region `region`; the last of `materials` serves all regions beyond them.
[[nodiscard]] const Material& materialOf(const std::vector<Material>& materials, int region);

/// rho * g in N/mm3 for an acceleration in m/s2.
[[nodiscard]] Vector3d bodyForce(const Material& material, const Vector3d& accelerationMPerS2);

}  // namespace falciform
