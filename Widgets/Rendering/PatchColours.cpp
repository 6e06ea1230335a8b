#include "Widgets/Rendering/PatchColours.h"

#include <array>

#include "Logic/Acquisition/ScanPreparationLogic.h"

namespace falciform {

Vector3d patchColour(int label) {
  if (scan_label::goes(label)) return scanMarkColour(static_cast<ScanMark>(label - scan_label::kFirst));
  static const std::array<Vector3d, 7> palette{Vector3d(0, 114, 178),    // blue: falciform
                                               Vector3d(240, 228, 66),   // yellow: inferior ridge
                                               Vector3d(0, 158, 115),    // bluish green
                                               Vector3d(204, 121, 167),  // reddish purple
                                               Vector3d(86, 180, 233),   // sky blue
                                               Vector3d(230, 159, 0),    // orange
                                               Vector3d(213, 94, 0)};    // vermilion
  constexpr int seed = 3;
  const int shown = label == scan_label::kSeed ? seed : label;
  const auto place = static_cast<std::size_t>(shown < 1 ? 0 : shown - 1) % palette.size();
  return palette[place] / 255.0;
}

Vector3d scanMarkColour(ScanMark mark) {
  switch (mark) {
    case ScanMark::Outlier:
      return {0.84, 0.37, 0.0};
    case ScanMark::Grazing:
      return {0.90, 0.62, 0.0};
    case ScanMark::SmallPiece:
      return {0.80, 0.47, 0.65};
    case ScanMark::OtherTissue:
      return {0.34, 0.71, 0.91};
    case ScanMark::ByHand:
      return {0.35, 0.35, 0.35};
    case ScanMark::Kept:
      break;
  }
  return kLiverColour;
}

Vector3d supportColour(SupportRegionKind kind, int label) {
  const bool other = label % 2 == 0;
  switch (kind) {
    case SupportRegionKind::Fixed:
      return other ? Vector3d(0.45, 0.85, 0.85) : Vector3d(0.40, 0.78, 0.98);
    case SupportRegionKind::Sliding:
      return other ? Vector3d(0.08, 0.20, 0.62) : Vector3d(0.20, 0.25, 0.75);
    case SupportRegionKind::Pushed:
      break;
  }
  return other ? Vector3d(0.96, 0.62, 0.05) : Vector3d(0.98, 0.85, 0.10);
}

Vector3d scanPatchColour(const Vector3d& colour) { return 0.45 * colour + 0.55 * Vector3d::Ones(); }

Vector3d scanPatchColour(int label) { return scanPatchColour(patchColour(label)); }

}  // namespace falciform
