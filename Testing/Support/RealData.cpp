#include "Testing/Support/RealData.h"

#include <cstdlib>

namespace falciform::test {

std::filesystem::path realData() {
  if (const char* folder = std::getenv("FALCIFORM_DATA"); folder && *folder) return folder;
  const char* source = std::getenv("FALCIFORM_SOURCE");
  return std::filesystem::path(source ? source : ".") / ".." / "shared" / "data";
}

}  // namespace falciform::test
