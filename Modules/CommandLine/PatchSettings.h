#pragma once
#include "Logic/Core/Settings.h"

namespace falciform::commandline {

/// Settings of transferPatches.
struct PatchTransferSettings {
  double radiusMm = 3.0;  ///< the thesis's
  bool keepOld = false;
};

template <class Visitor>
void describe(PatchTransferSettings& s, Visitor&& field) {
  field(FieldInfo{"radiusMm", "Patch radius", "mm", 0.01, 100,
                  "A point takes the label of a painted point no farther than this."},
        s.radiusMm);
  field(FieldInfo{"keepOld", "Keep old patches", "", 0, 1,
                  "Points beyond the radius keep the label they have."},
        s.keepOld);
}

}  // namespace falciform::commandline
