#pragma once
#include "Testing/Verification/HeldBody.h"

namespace falciform::verification {

/// Liver tissue of 200 x 150 x 80 mm, one end fixed, as elements of about a liver's size see it.
enum class BlockLoad {
  OwnWeight,  ///< sags along z
  Packed      ///< a place of 50 x 50 mm below the free end is pushed up by 10 mm
};

/// `boxMm`: 25 mm, or a part of it (a box is six tetrahedra), so that the packed place has the same edges on
/// every mesh.
[[nodiscard]] HeldBody packedBlock(double poissonsRatio, bool quadratic, double boxMm, BlockLoad load);

/// How stiff the block is, N/mm: its weight by the mean sag of the free end, or the force on the packed place
/// along the push, by the push.
[[nodiscard]] double blockStiffness(const HeldBody& block, BlockLoad load);

}  // namespace falciform::verification
