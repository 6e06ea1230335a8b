#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform::test {

/// A real liver deformed with known truth: a folder of `update/` in the real cases, or one in the same layout
/// made by `./run bench make-truths`.
struct UpdateCase {
  std::string name;
  Surface preop;              ///< LPS mm, patches painted
  Surface scan;               ///< scanner mm, patches painted
  Points targetsPreop;        ///< targets before, LPS mm
  Points targetsScanner;      ///< the same targets where they truly are, scanner mm
  double optimalRigidMm = 0;  ///< mean target error of the best rigid motion there is
  double coverage = 0;
};

/// `update/` in the real cases.
[[nodiscard]] std::filesystem::path updateCasesFolder();
/// Names of the cases in a folder of cases, alphabetically.
[[nodiscard]] std::vector<std::string> updateCaseNames(
    const std::filesystem::path& cases = updateCasesFolder());
[[nodiscard]] UpdateCase readUpdateCase(const std::string& name,
                                        const std::filesystem::path& cases = updateCasesFolder());

}  // namespace falciform::test
