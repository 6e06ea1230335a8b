#pragma once
#include "Testing/Verification/Calculix.h"

namespace falciform::verification {

/// A neo-Hookean bar along x of 40 x 10 x 10 mm, rolling on the planes x = 0, y = 0 and z = 0.
enum class BarLoad {
  EndTraction,        ///< by unit of the undeformed end's area, along x; the sides are free
  OwnWeightConfined,  ///< gravity along -x; the sides x-y and x-z roll on planes all round
};
inline constexpr double kBarLengthMm = 40, kBarWidthMm = 10;

/// `load`: MPa, or m/s2. `layers` of cubes, two by two across, stand along x; each is six quadratic
/// tetrahedra.
[[nodiscard]] SharedProblem neoHookeanBar(const Material& material, BarLoad kind, double load,
                                          int layers = 8);

/// What a point at height x of the undeformed bar and at y, z of its section moves by.
struct BarMotion {
  double alongMm = 0;   ///< at x
  double widening = 0;  ///< displacement across by distance from the axis planes
};

/// The closed forms, from the energy's principal stresses: a stretch that leaves the sides free of stress; or
/// the stretch along x alone that bears the weight above each place, integrated over the height.
[[nodiscard]] BarMotion neoHookeanBarMotion(const Material& material, BarLoad kind, double load, double x);

}  // namespace falciform::verification
