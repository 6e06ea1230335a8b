#pragma once
#include "Logic/Core/Settings.h"

namespace falciform {

/// What an operating room and a real scanner add to a clean scan; nothing by default.
struct ScanFaultSettings {
  double baselineMm = 0;             ///< from camera to laser; what either does not see is in the shadow
  bool noiseGrowsWithRange = false;  ///< as the RealScan's does; the stated noise is then that at the middle
  double dropout = 0;       ///< chance that a ray at the grazing limit is lost; 0 where it meets head-on
  double smoke = 0;         ///< share of the rays that return from smoke before the surface
  int instruments = 0;      ///< rods over the organ
  bool drape = false;       ///< a wavy cloth around the organ
  bool photograph = false;  ///< the scanner's picture as texture of the scan
  int faultSeed = 1;
};

template <class Visitor>
void describe(ScanFaultSettings& s, Visitor&& field) {
  field(FieldInfo{"baselineMm", "Baseline", "mm", 0, 400,
                  "From camera to laser, sideways: what the laser does not reach is lost. 0: no shadows."},
        s.baselineMm);
  field(
      FieldInfo{"noiseGrowsWithRange", "Noise grows with range", "", 0, 0,
                "As the RealScan 200C's, 0.3 mm at 300 mm to 1 mm at 800 mm; the noise given is that at the "
                "scanner's distance."},
      s.noiseGrowsWithRange);
  field(FieldInfo{"dropout", "Dropout", "", 0, 1,
                  "Chance that a ray is lost at the grazing limit; none where it meets the surface head-on."},
        s.dropout);
  field(FieldInfo{"smoke", "Smoke", "", 0, 0.5, "Share of the rays that return from smoke over the organ."},
        s.smoke);
  field(FieldInfo{"instruments", "Instruments", "", 0, 10, "Rods of 8 mm over the organ."}, s.instruments);
  field(FieldInfo{"drape", "Drape", "", 0, 0, "A wavy blue-green cloth around the organ is seen too."},
        s.drape);
  field(FieldInfo{"photograph", "Photograph", "", 0, 0,
                  "The scan carries the scanner's photograph as texture, 1280 pixels wide."},
        s.photograph);
  field(FieldInfo{"faultSeed", "Seed of the faults", "", 0, 2147483647,
                  "Draws instruments, cloth, smoke and lost rays."},
        s.faultSeed);
}

}  // namespace falciform
