#include "Logic/Biomechanics/BlasKernel.h"

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string_view>

extern "C" {
__attribute__((weak)) char* openblas_get_corename();
}

namespace falciform {

void restartWithBestBlasKernel([[maybe_unused]] char** arguments) {
#ifdef __x86_64__
  constexpr const char* kName = "OPENBLAS_CORETYPE";
  if (openblas_get_corename == nullptr || std::getenv(kName) != nullptr) return;
  __builtin_cpu_init();
  if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512vl") ||
      !__builtin_cpu_supports("avx512bw") || !__builtin_cpu_supports("avx512dq"))
    return;
  constexpr std::array<std::string_view, 3> kWide{"SkylakeX", "Cooperlake", "SapphireRapids"};
  for (const std::string_view core : kWide)
    if (core == openblas_get_corename()) return;
  if (setenv(kName, "SkylakeX", 0) == 0) execv("/proc/self/exe", arguments);
#endif
}

}  // namespace falciform
