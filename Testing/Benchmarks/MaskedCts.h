#pragma once
#include <vector>

#include "Logic/Core/Volume.h"
#include "Logic/Segmentation/Mask.h"

namespace falciform::bench {

/// Clicks as a clinician would make them.
struct Clicks {
  const char* what;
  std::vector<Vector3d> places;  ///< LPS mm
};

/// A real CT with a mask of its liver.
struct MaskedCt {
  const char *name, *ct, *mask;  ///< files below the real data's folder
  int label;                     ///< of the mask; 0: any above 0
  std::vector<Clicks>
      clicks;  ///< chosen on the axial slices: in the middle of what one sees, away from vessels
};
[[nodiscard]] const std::vector<MaskedCt>& maskedCts();

[[nodiscard]] Points pointsOf(const std::vector<Vector3d>& places);

/// Both masks in the box of their union and three voxels around it.
struct MaskPair {
  Mask a, b;
};
[[nodiscard]] MaskPair cropped(const LabelMap& a, const LabelMap& b, int label);

[[nodiscard]] double diceOf(const MaskPair& pair);

}  // namespace falciform::bench
