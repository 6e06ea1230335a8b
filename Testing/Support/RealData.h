#pragma once
#include <gtest/gtest.h>

#include <filesystem>

namespace falciform::test {

/// The folder of real cases: FALCIFORM_DATA, else ../shared/data beside the source tree. May not exist.
[[nodiscard]] std::filesystem::path realData();

}  // namespace falciform::test

/// First line of a test that reads `relative` (a file or folder of the real cases): skips with a message
/// where it is absent.
#define FALCIFORM_NEEDS_DATA(relative)                                            \
  if (!std::filesystem::exists(falciform::test::realData() / (relative)))         \
  GTEST_SKIP() << "needs " << (falciform::test::realData() / (relative)).string() \
               << "; set FALCIFORM_DATA to the folder of real cases"
