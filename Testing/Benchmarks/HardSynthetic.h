#pragma once

namespace falciform::bench {

/// Prints the hard synthetic: 21 % visible, 5.5 mm RMS of bending, 1 mm noise; ours and Open3D, on the livers
/// `first`, `first` + 1, ... `details`: also a line a registration, with what its warnings rest on.
void printHardSynthetic(int first, int cases, bool details);

}  // namespace falciform::bench
