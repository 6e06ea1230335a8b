#include "Logic/Biomechanics/BlasKernel.h"

#include <unistd.h>

#include <cstdlib>

namespace falciform {

void restartWithBestBlasKernel([[maybe_unused]] char** arguments) {
#ifdef __x86_64__
  constexpr const char* kName = "OPENBLAS_CORETYPE";
  if (std::getenv(kName) != nullptr) return;
  __builtin_cpu_init();
  if (!__builtin_cpu_is("amd") || !__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512vl") ||
      !__builtin_cpu_supports("avx512bw") || !__builtin_cpu_supports("avx512dq"))
    return;
  if (setenv(kName, "SkylakeX", 0) == 0) execv("/proc/self/exe", arguments);
#endif
}

}  // namespace falciform
