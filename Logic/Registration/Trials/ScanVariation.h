#pragma once
#include <cstdint>

#include "Logic/Core/Settings.h"
#include "Logic/Core/Surface.h"

namespace falciform {

/// How a trial's scan differs from the one that was measured, besides where it lies. A method whose result
/// does not depend on where the scan lies has only one trial without this.
struct ScanVariation {
  double keepShare = 1;      ///< of the scan's points, each by its own chance
  double noiseMm = 0;        ///< standard deviation per axis
  double outlierShare = 0;   ///< of the points, thrown 10 to 50 mm in any direction with their labels
  double mislabelShare = 0;  ///< of the patch points, that give their label to any other point of the scan
};

template <class Visitor>
void describe(ScanVariation& s, Visitor&& field) {
  field(FieldInfo{"keepShare", "Share kept", "", 0.01, 1,
                  "Of the scan's points, drawn anew for each trial: makes trials independent of each other."},
        s.keepShare);
  field(FieldInfo{"noiseMm", "Noise", "mm", 0, 50,
                  "Standard deviation per axis, added to each point anew for each trial."},
        s.noiseMm);
  field(FieldInfo{"outlierShare", "Outliers", "", 0, 0.9,
                  "Share of the points that are thrown 10 to 50 mm in any direction."},
        s.outlierShare);
  field(FieldInfo{"mislabelShare", "Mislabelled", "", 0, 1,
                  "Share of the scan's patch points that give their label to any other point of the scan."},
        s.mislabelShare);
}

/// The scan of one trial: random numbers of its own from (seed, trial), apart from those of its perturbation.
/// The same surface where nothing is asked for.
[[nodiscard]] Surface variedScan(const Surface& scan, const ScanVariation& variation, std::uint64_t seed,
                                 std::uint64_t trial);

}  // namespace falciform
