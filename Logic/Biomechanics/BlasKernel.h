#pragma once

namespace falciform {

/// Starts the program anew with OPENBLAS_CORETYPE=SkylakeX, once, where OpenBLAS has chosen a kernel without
/// AVX-512 on a processor that has it (Debian 12's knows some newer ones only as the Haswell of 2013, and
/// then leaves half of them unused). It reads the variable before main, so there is no gentler way. Does
/// nothing elsewhere, or where the variable is set. Call it first in main, before anything is read or
/// written.
void restartWithBestBlasKernel(char** arguments);

}  // namespace falciform
