#pragma once
#include "Logic/Segmentation/LevelSet.h"
#include "Logic/Segmentation/LevelSetGrowth.h"
#include "Logic/Segmentation/SeedGroups.h"
#include "Logic/Segmentation/VolumePyramid.h"

namespace falciform {

/// One tissue of the organ and what the first growth made of it on the coarsest level.
struct GrownTissue {
  SeedGroup group;
  Volume<std::uint8_t> region;
};

/// The organ after the first growth.
struct LevelSetStart {
  std::vector<GrownTissue> tissues;  ///< the parenchyma first
  Volume<std::uint8_t> region;       ///< all of them, what one goes on from, gaps filled
  double neckMm = 0;                 ///< of the parenchyma's growth
  std::vector<LeftOut> leftOut;
  std::vector<EnclosedPart> enclosed;  ///< darker bodies taken in
  std::vector<std::string> warnings;
};

/// `kept` and `forbidden` are shares of the coarsest level's voxels, empty images if there are none.
[[nodiscard]] LevelSetStart growStart(const PyramidLevel& level, const std::vector<Vector3d>& seeds,
                                      const Image& kept, const Image& forbidden,
                                      const LevelSetSettings& settings, const Progress& progress);

}  // namespace falciform
