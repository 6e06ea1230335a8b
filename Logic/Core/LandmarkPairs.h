#pragma once
#include "Logic/Core/Landmarks.h"

namespace falciform {

/// N x 3 positions, mm, in the order of the list.
[[nodiscard]] Points positionsOf(const Landmarks& landmarks);

/// Rows of both that belong together, paired by name where all names of both lists agree, else by order.
/// Throws InputError if the lists are empty or of different length.
struct PairedTargets {
  Points preop, scan;  ///< N x 3, mm
};
[[nodiscard]] PairedTargets pairTargets(const Landmarks& targets, const Landmarks& truth);

}  // namespace falciform
