#pragma once
#include <limits>
#include <string>
#include <vector>

#include "Logic/Atlas/AtlasDesign.h"
#include "Logic/Biomechanics/SupportSites.h"
#include "Logic/Biomechanics/Supports.h"

namespace falciform {

/// Members that share supports and tissue, so that they differ by their load alone.
struct AtlasSetup {
  std::string name;
  std::vector<Support> supports;  ///< the pushed one, if there is any, by 1 mm
  int pushed = -1;                ///< which of them is pushed, or -1
  Vector3d centreMm = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());  ///< of what is pushed
  double extentMm = 0;
  double stiffnessRatio = 0;  ///< of tumours to liver; 0: the design's materials as they stand
};

/// One deformation: a load on a setup.
struct AtlasMember {
  int setup = 0;
  double pushMm = 0;
  Vector3d gravityMPerS2 = Vector3d::Zero();        ///< as it is now; zero where the design has none
  Vector3d gravityChangeMPerS2 = Vector3d::Zero();  ///< what loads the liver

  /// Push, then the change of gravity: what the deformation is linear in.
  [[nodiscard]] Eigen::RowVector4d load() const {
    return {pushMm, gravityChangeMPerS2[0], gravityChangeMPerS2[1], gravityChangeMPerS2[2]};
  }
};

struct AtlasMembers {
  std::vector<AtlasSetup> setups;    ///< in order of stiffness ratio
  std::vector<AtlasMember> members;  ///< by setup
};

/// What a design means on a liver. The same for the same sites and design. Throws InputError if a support
/// set is nowhere on this liver, or places do not fit.
[[nodiscard]] AtlasMembers membersOf(const AtlasDesign& design, const SupportSites& sites);

}  // namespace falciform
