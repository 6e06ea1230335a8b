#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform::test {

/// A real liver deformed with known truth: a folder of `update/` in the real cases.
struct UpdateCase {
  std::string name;
  Surface preop;              ///< LPS mm, patches painted
  Surface scan;               ///< scanner mm, patches painted
  Points targetsPreop;        ///< targets before, LPS mm
  Points targetsScanner;      ///< the same targets where they truly are, scanner mm
  double optimalRigidMm = 0;  ///< mean target error of the best rigid motion there is
  double coverage = 0;
};

/// Names of the cases, alphabetically.
[[nodiscard]] std::vector<std::string> updateCaseNames();
[[nodiscard]] UpdateCase readUpdateCase(const std::string& name);

}  // namespace falciform::test
