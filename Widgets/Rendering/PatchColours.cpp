#include "Widgets/Rendering/PatchColours.h"

#include <array>

namespace falciform {

Vector3d patchColour(int label) {
  static const std::array<Vector3d, 7> palette{Vector3d(0, 114, 178),    // blue: falciform
                                               Vector3d(240, 228, 66),   // yellow: inferior ridge
                                               Vector3d(0, 158, 115),    // bluish green
                                               Vector3d(204, 121, 167),  // reddish purple
                                               Vector3d(86, 180, 233),   // sky blue
                                               Vector3d(230, 159, 0),    // orange
                                               Vector3d(213, 94, 0)};    // vermilion
  const auto place = static_cast<std::size_t>(label < 1 ? 0 : label - 1) % palette.size();
  return palette[place] / 255.0;
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
