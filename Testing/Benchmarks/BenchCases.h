#pragma once
#include <optional>
#include <string>
#include <vector>

#include "Logic/Core/Surface.h"
#include "Logic/Registration/RegistrationSettings.h"

namespace falciform::bench {

/// A pre-op surface and a scan of it with the truth: what every benchmark of registration is run on.
struct BenchCase {
  std::string name;
  Surface preop;         ///< LPS mm, patches painted
  Surface scan;          ///< scanner mm, patches painted, normals to the right side
  Points targetsPreop;   ///< where the error is taken, LPS mm
  Points targetsScan;    ///< the same places where they truly are, scanner mm
  Isometry3d bestRigid;  ///< scanFromPreop with the least target error: the truth if nothing bends
  double optimalMm = 0;  ///< mean target error of bestRigid
  double limitMm = 0;    ///< a registration succeeds if its mean target error is below
  double coverage = 0;   ///< share of the surface's area that was seen
};

/// Mean target error of a pose, mm.
[[nodiscard]] double targetErrorMm(const BenchCase& c, const Isometry3d& scanFromPreop);
/// Mean distance of the targets under the pose from where the best rigid motion puts them, mm.
[[nodiscard]] double apartFromBestMm(const BenchCase& c, const Isometry3d& scanFromPreop);

/// The built-in liver (58,199 points) and a scan of it (15,004), rigid. Targets: the surface's points.
[[nodiscard]] BenchCase builtInCase();
/// The virtual phantom of chapter III, CT surface and whole scan. Targets: the CT surface's points.
[[nodiscard]] BenchCase phantomCase();
/// A real liver of `update/`, bent; nothing where the real cases are not there. Success: 1.4 x optimal + 0.5
/// mm.
[[nodiscard]] std::optional<BenchCase> realCase(const std::string& name);

/// Gives each scan point the normal of the pre-op point that it lies on. Ours does not look at it; peers that
/// estimate normals turn theirs to the same side, so that none fails for want of a side.
void addNormals(BenchCase& c);

/// Ours: name and settings.
struct OurMethod {
  std::string name;
  RegistrationSettings settings;
};
/// Two patches, one patch (falciform), auto.
[[nodiscard]] std::vector<OurMethod> ourMethods();

}  // namespace falciform::bench
