#pragma once
#include "Logic/Segmentation/LevelSet.h"
#include "Logic/Segmentation/LevelSetTissue.h"
#include "Logic/Segmentation/StorageOrder.h"

namespace falciform {

/// Parts of the organ that hang on by a neck narrower than `neckMm` though they are wider themselves, by the
/// factor `wideness` at least: what a leak looks like. The first is the largest; parts below `leastMl` are
/// left out, and so is the part with most of the organ.
[[nodiscard]] std::vector<LeftOut> partsBehindNecks(const Volume<std::uint8_t>& organ, double neckMm,
                                                    double wideness, double leastMl);

/// Share of the organ's border where the image, `reachMm` inside and outside of it, is equally bright.
[[nodiscard]] double weakBorderShare(const Image& image, const Image& phi, const Tissue& tissue,
                                     double reachMm);

/// Which of the volume's six sides the organ touches, in words: "top", "left", ... by the axes nearest LPS.
[[nodiscard]] std::vector<std::string> sidesTouched(const LabelMap& organ, const StorageOrder& order);

/// Says in plain words where the front may have leaked or stopped short.
void warnOfLeaks(LevelSetResult& result, const LevelSetSettings& settings,
                 const std::vector<LeftOut>& behindNecks, const std::vector<std::string>& sides);

}  // namespace falciform
