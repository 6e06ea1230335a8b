#include "Testing/Support/RealData.h"

#include <cstdlib>

namespace falciform::test {

std::filesystem::path realData() {
  if (const char* folder = std::getenv("FALCIFORM_DATA"); folder && *folder) return folder;
  return std::filesystem::path(FALCIFORM_SOURCE_DIR) / ".." / "shared" / "data";
}

}  // namespace falciform::test
