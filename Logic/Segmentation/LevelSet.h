#pragma once
#include <functional>
#include <string>
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Volume.h"
#include "Logic/Segmentation/LevelSetSettings.h"
#include "Logic/Segmentation/Mask.h"

namespace falciform {

/// What a segmentation starts from.
struct LevelSetInput {
  const Image& ct;
  Points seeds = Points(0, 3);          ///< clicks in the organ, LPS mm
  const LabelMap* start = nullptr;      ///< to go on from: voxels above 0 are organ; on the CT's grid
  const LabelMap* forbidden = nullptr;  ///< voxels above 0 are never organ; on the CT's grid
};

/// Tissue of the organ's brightness that the front did not enter because the way is narrow.
struct LeftOut {
  double neckMm = 0, volumeMl = 0;
  Vector3d place = Vector3d::Zero();  ///< LPS mm
};

/// A darker body that was taken in because the organ encloses most of it: a tumour that reaches the border.
struct EnclosedPart {
  double volumeMl = 0;                ///< in the first growth; the level set may have moved its border since
  double levelHu = 0;                 ///< its median
  double enclosedShare = 0;           ///< of its border, what lies at the lung left out
  Vector3d place = Vector3d::Zero();  ///< LPS mm
};

struct LevelSetResult {
  LabelMap labels;  ///< 1 is the organ; the CT's grid
  double volumeMl = 0;
  double tissueLevelHu = 0, tissueSpreadHu = 0;
  double neckMm = 0;           ///< radius of the narrowest neck that the front was let through
  double weakBorderShare = 0;  ///< of the border where the image shows no edge
  std::vector<LeftOut> leftOut;
  std::vector<EnclosedPart> enclosed;  ///< largest first; each is told in the warnings too
  std::vector<std::string> warnings;
};

/// Gets the organ as it stands now, on a coarser grid, after the first growth, each time step and each level.
/// Called on the thread that computes.
using LevelSetPreview = std::function<void(const Mask& soFar)>;

/// Segments an organ of even brightness from a few clicks (thesis ch. II, Eq. II.1): the tissue's statistics
/// from the seeds' neighbourhoods; a first growth on the coarsest level, whose front remembers the narrowest
/// place it came through; then darker bodies that it encloses for the most part (enclosedBodies), each a
/// tissue of its own; then a level set with an accumulative speed from coarse to fine; then the piece or
/// pieces with seeds, cavities filled. Seeds in tissue unlike the others' (a tumour) grow with their own
/// statistics. Warns wherever the front may have leaked, or may have stopped short. Independent of how the
/// volume is stored and of the number of threads. Throws InputError for an empty or unusable volume, no seed
/// and no start, a seed outside the volume, a map on another grid.
[[nodiscard]] LevelSetResult segmentLevelSet(const LevelSetInput& input, const LevelSetSettings& settings,
                                             const Progress& progress = {},
                                             const LevelSetPreview& preview = {});

}  // namespace falciform
