#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Settings.h"
#include "Logic/Core/Surface.h"
#include "Logic/Core/TrackedPoints.h"

namespace falciform {

/// How a swab of the tracked stylus becomes a patch.
struct SwabSettings {
  double widthMm = 10;    ///< of the patch, across the way of the tip
  double liftOffMm = 6;   ///< a point farther from the surface was not taken on it
  double outlierMm = 10;  ///< a point farther from the middle of those just before and after it is an outlier
  double gapMm = 25;      ///< points of one stroke farther apart are not joined
};

template <class Visitor>
void describe(SwabSettings& s, Visitor&& field) {
  field(FieldInfo{"swabWidthMm", "Swab width", "mm", 0.5, 60, "Width of the patch along the way of the tip."},
        s.widthMm);
  field(FieldInfo{"liftOffMm", "Lift-off", "mm", 0.1, 50,
                  "Points of the tip farther from the surface are left out."},
        s.liftOffMm);
  field(FieldInfo{"outlierMm", "Outlier", "mm", 0.5, 100,
                  "Points farther from the middle of those just before and after are left out."},
        s.outlierMm);
  field(FieldInfo{"gapMm", "Longest gap", "mm", 1, 200,
                  "Points of one stroke that are farther apart are not joined."},
        s.gapMm);
}

struct SwabPatch {
  std::vector<int> vertices;                  ///< of the surface, ascending
  int used = 0, liftedOff = 0, outliers = 0;  ///< points of the swab
  double lengthMm = 0;                        ///< of the way along the surface
  std::vector<std::string> warnings;          ///< few points left, most lifted off
};

/// The vertices within half the width of the way of the tip over the surface; strokes are not joined to each
/// other. Points and surface are in one frame. Throws InputError if no point lies on the surface.
[[nodiscard]] SwabPatch patchOfSwab(const Surface& surface, const TrackedPoints& swab,
                                    const SwabSettings& settings = {});

}  // namespace falciform
