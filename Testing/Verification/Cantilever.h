#pragma once
#include "Testing/Verification/HeldBody.h"

namespace falciform::verification {

enum class CantileverLoad { OwnWeight, EndShear };

/// A bar of 100 x 10 x 10 mm, clamped at one end.
[[nodiscard]] HeldBody cantilever(double poissonsRatio, bool quadratic, int cellsThroughDepth,
                                  CantileverLoad load);

/// The mean sag of the free end over its face, mm.
[[nodiscard]] double endSagMm(const HeldBody& bar, const Points& displacements);

/// The same by Timoshenko's beam: bending and shear, with Cowper's coefficient 10 (1 + nu) / (12 + 11 nu). A
/// beam takes no notice of how the clamp keeps its section from widening, so that a solid sags less than it
/// unless nu is 0.
[[nodiscard]] double timoshenkoSagMm(double poissonsRatio, CantileverLoad load);

}  // namespace falciform::verification
