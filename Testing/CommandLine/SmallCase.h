#pragma once
#include <filesystem>

#include "Logic/Core/Surface.h"
#include "Logic/Core/Volume.h"

namespace falciform::test {

/// A body with two patches and a partial scan of it, small enough to register in a blink, with known truth.
struct SmallCase {
  Surface preop;
  Surface scan;              ///< frame "scanner"
  Isometry3d scanFromPreop;  ///< the truth
};
[[nodiscard]] SmallCase smallCase();

/// preop.vtp and scan.vtp of it.
SmallCase writeSmallCase(const std::filesystem::path& folder);

/// A ball of label 3 and radius 60 mm, 0.9 l, in a volume of 4 mm voxels; `scale` 0.001 stores it as if in
/// metres.
[[nodiscard]] LabelMap ballMap(double scale = 1);

}  // namespace falciform::test
