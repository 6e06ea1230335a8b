#pragma once
#include <cstdint>

#include "Logic/Deformation/Cohort/Cohort.h"

namespace falciform::test {

/// Ten cases as the thesis's: three of A, two of B, three of C, two of their own. Their maps on 300 vertices
/// vary smoothly, being made of 12 waves; `groupShare`, in [0, 1], of each wave's variance is common to the
/// cases of a group, and is the correlation expected in it. 0: groups mean nothing. `commonPattern`: strength
/// of one more pattern that every case has, more or less and of either sign, whatever its group: it makes the
/// correlations of one case with the others hang together.
[[nodiscard]] Cohort randomCohort(double groupShare, std::uint64_t seed, double commonPattern = 0);

}  // namespace falciform::test
