#include "Logic/Acquisition/TissueColour.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Draws.h"
#include "Logic/Core/Surface.h"

namespace falciform {
namespace {

double latticeValue(const Vector3d& corner) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis)
    key = key * 0x100000001b3ULL + static_cast<std::uint64_t>(static_cast<std::int64_t>(corner[axis]));
  return Draws(key, 3).uniform(-1, 1);
}

/// Smooth noise in [-1, 1] with lumps of about one unit: values at the corners of a unit lattice, blended.
double valueNoise(const Vector3d& p) {
  const Vector3d low = p.array().floor();
  Vector3d t = p - low;
  t = t.array().square() * (3 - 2 * t.array());
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d step(corner & 1, corner >> 1 & 1, corner >> 2);
    double weight = 1;
    for (int axis = 0; axis < 3; ++axis) weight *= step[axis] > 0 ? t[axis] : 1 - t[axis];
    sum += weight * latticeValue(low + step);
  }
  return sum;
}

}  // namespace

std::array<std::uint8_t, 3> tissueColour(const Vector3d& place, int patchLabel) {
  const Vector3d parenchyma(146, 68, 56), ligament(205, 168, 146);
  const double mottle = 0.7 * valueNoise(place / 14) + 0.3 * valueNoise(place / 4);
  const Vector3d colour = (patchLabel == patch::kFalciform ? ligament : parenchyma) * (1 + 0.13 * mottle);
  std::array<std::uint8_t, 3> rgb{};
  for (int k = 0; k < 3; ++k)
    rgb[static_cast<std::size_t>(k)] =
        static_cast<std::uint8_t>(std::lround(std::clamp(colour[k], 0.0, 255.0)));
  return rgb;
}

}  // namespace falciform
