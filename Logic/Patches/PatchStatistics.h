#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform {

/// What is painted: one row a label.
struct PatchStatistics {
  int label = 0;
  std::string name;
  Index points = 0;
  double areaMm2 = 0;   ///< of the label's share of vertex areas; 0 for a cloud
  double lengthMm = 0;  ///< extent along its longest principal axis
  double widthMm = 0;   ///< extent along the second
  int pieces = 0;       ///< connected pieces by mesh edges (clouds: by points closer than 3 mean spacings)
  Vector3d centroid = Vector3d::Zero();
};
[[nodiscard]] std::vector<PatchStatistics> patchStatistics(const Surface& surface);

/// Plain-word warnings: nothing painted, a patch of fewer than 20 points, of one label on one side only.
[[nodiscard]] std::vector<std::string> patchWarnings(const Surface& preop, const Surface& scan);

}  // namespace falciform
