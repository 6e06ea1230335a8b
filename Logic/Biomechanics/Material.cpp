#include "Logic/Biomechanics/Material.h"

#include <algorithm>
#include <string>

#include "Logic/Core/Errors.h"
#include "Logic/Core/NumberText.h"

namespace falciform {

double shearModulusMPa(const Material& material) {
  return material.youngsModulusMPa / (2 * (1 + material.poissonsRatio));
}

double lameLambdaMPa(const Material& material) {
  const double nu = material.poissonsRatio;
  return material.youngsModulusMPa * nu / ((1 + nu) * (1 - 2 * nu));
}

void checkMaterial(const Material& material, const std::string& what) {
  if (!(material.youngsModulusMPa > 0))
    throw InputError("Young's modulus of " + what + " is " + numberText(material.youngsModulusMPa * 1e3) +
                     " kPa; give a value above 0 (liver: about 2 to 15 kPa)");
  if (!(material.poissonsRatio > -1 && material.poissonsRatio <= 0.4999))
    throw InputError("Poisson's ratio of " + what + " is " + numberText(material.poissonsRatio) +
                     "; displacement elements need it above -1 and at most 0.4999 (0.5 is incompressible; "
                     "0.47 to 0.49 is usual for liver)");
  if (!(material.densityKgPerM3 >= 0))
    throw InputError("density of " + what + " is " + numberText(material.densityKgPerM3) +
                     " kg/m3; give 0 or more (tissue: about 1000)");
}

const Material& materialOf(const std::vector<Material>& materials, int region) {
  return materials[std::min(static_cast<std::size_t>(region), materials.size() - 1)];
}

Vector3d bodyForce(const Material& material, const Vector3d& accelerationMPerS2) {
  return material.densityKgPerM3 * 1e-9 * accelerationMPerS2;  // kg/m3 * m/s2 = N/m3
}

}  // namespace falciform
