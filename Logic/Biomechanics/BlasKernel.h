#pragma once

namespace falciform {

/// Starts the program anew with OPENBLAS_CORETYPE=SkylakeX, once, where that is faster: Debian 12's OpenBLAS takes AMD
/// processors with AVX-512 for the Haswell of 2013 and leaves half of them unused. It reads the variable before main,
/// so there is no gentler way. Does nothing elsewhere, or where the variable is set. Call it first in main, before
/// anything is read or written; returns if nothing is to be done.
void restartWithBestBlasKernel(char** arguments);

}  // namespace falciform
