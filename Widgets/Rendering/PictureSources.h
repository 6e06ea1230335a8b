#pragma once
#include <map>
#include <memory>
#include <string>

#include "Logic/Core/Results.h"
#include "Logic/Core/Surface.h"

namespace falciform {

struct PictureSize {
  int width = 1200, height = 900;  ///< pixels, each in [64, 8192]
};

/// Vessels and tumours by name, in the frame of the pre-operative surface.
using Structures = std::map<std::string, std::shared_ptr<const Surface>>;

enum class DistanceSide { Preop, Scan };

/// What there is to draw; what is null is left out.
struct PictureSources {
  std::shared_ptr<const Surface> preop, scan;
  std::shared_ptr<const RegistrationResult> registration;
  std::shared_ptr<const DistanceMap> distance;
  Structures structures;
  Isometry3d scanFromPreopStart = Isometry3d::Identity();  ///< pose before the registration, for before.png
};

}  // namespace falciform
