#pragma once
#include "Logic/Acquisition/ScanPreparation.h"
#include "Logic/Core/SupportPainting.h"
#include "Logic/Core/Types.h"

namespace falciform {

// All colours: red, green, blue in [0, 1].

inline const Vector3d kLiverColour{0.80, 0.52, 0.42};
/// Of what is drawn where it was before it moved.
inline const Vector3d kBeforeColour{0.90, 0.60, 0.00};
inline const Vector3d kScanColour{0.74, 0.70, 0.68};  ///< of a scan without colours of its own

/// Colour of a patch label above 0: the palette of Okabe and Ito (2008), which the colour blind can tell
/// apart, in an order that stands out on the liver's colour; repeats after the seventh. The labels by which
/// scan preparation shows its marks (scan_label) have scanMarkColour() instead.
[[nodiscard]] Vector3d patchColour(int label);

/// Colour of what becomes of a scan's point: none is the falciform's blue or the ridge's yellow.
[[nodiscard]] Vector3d scanMarkColour(ScanMark mark);

/// The same patch on the scan, where both sides are shown: the same hue, much lighter.
[[nodiscard]] Vector3d scanPatchColour(int label);
[[nodiscard]] Vector3d scanPatchColour(const Vector3d& patchColour);

/// Colour of a painted support, after the thesis's Fig. V.6: fixed light blue, sliding dark blue, pushed
/// yellow; a little different from label to label, so that two of a kind can be told apart.
[[nodiscard]] Vector3d supportColour(SupportRegionKind kind, int label);

}  // namespace falciform
