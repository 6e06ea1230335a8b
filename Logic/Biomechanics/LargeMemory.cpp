#include "Logic/Biomechanics/LargeMemory.h"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace falciform {

void FreeMemory::operator()(void* data) const { std::free(data); }

void* allocateLarge(std::size_t bytes) {
  constexpr std::size_t kLargePage = std::size_t{1} << 21;
  const bool large = bytes >= kLargePage;
  void* data = large ? std::aligned_alloc(kLargePage, (bytes + kLargePage - 1) / kLargePage * kLargePage)
                     : std::malloc(bytes > 0 ? bytes : 1);
  if (data == nullptr) throw std::bad_alloc();
  if (large) (void)madvise(data, bytes, MADV_HUGEPAGE);  // a wish: without it all works, slower
  return data;
}

}  // namespace falciform
