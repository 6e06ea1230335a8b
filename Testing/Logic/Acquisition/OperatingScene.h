#pragma once
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform::test {

struct OperatingScenePlan {
  double noiseMm = 0.4;  ///< standard deviation along the rays
  double outlierShare =
      0.0;         ///< of the samples: half as loose returns in the air, half as spikes in the mesh
  int stride = 3;  ///< of a raster of 500 x 512
  int seed = 1;
};

/// A scan of an opened abdomen with known truth: a synthetic liver in a bed of gauze, a pad of fat against
/// it, a steel retractor above its edge and two white spheres, in their colours with shading and noise, in
/// the scanner's frame.
struct OperatingScene {
  Surface scan;                  ///< triangulated, colours, patches 1 and 2 of the liver
  std::vector<char> liver;       ///< one a point: it is liver, and no outlier
  std::vector<char> outlier;     ///< one a point
  Vector3d onLiver, onLigament;  ///< places to click
};
[[nodiscard]] OperatingScene makeOperatingScene(const OperatingScenePlan& plan);

/// 2 |A and B| / (|A| + |B|).
[[nodiscard]] double diceOf(const std::vector<char>& a, const std::vector<char>& b);

}  // namespace falciform::test
