#pragma once
#include <memory>

#include "Logic/Core/Case.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {

/// A case whose scan is a sphere `gapMm` outside of its liver, a sphere of 50 mm with a patch, in the
/// scanner's frame, registered by its true pose.
inline void fillSpheres(Case& document, double gapMm, const Isometry3d& scanFromPreop) {
  Surface inner = sphere(50, 4), outer = sphere(50 + gapMm, 4);
  inner.patch.assign(static_cast<std::size_t>(inner.size()), patch::kNone);
  for (Index i = 0; i < inner.size(); ++i)
    if (inner.points(i, 2) > 30) inner.patch[static_cast<std::size_t>(i)] = patch::kFalciform;
  outer.patch = inner.patch;
  document.setPreop(std::make_shared<const Surface>(inner));
  document.setScan(std::make_shared<const Surface>(transformed(outer, scanFromPreop, "scanner")));
  auto result = std::make_shared<RegistrationResult>();
  result->scanFromPreop = scanFromPreop;
  document.setRegistration(result);
}

}  // namespace falciform::test
