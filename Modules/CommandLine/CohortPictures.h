#pragma once
#include "Modules/CommandLine/CohortChain.h"
#include "Widgets/Rendering/Pictures.h"

namespace falciform::commandline {

/// overlap.png, then NAME.png of each case.
[[nodiscard]] std::vector<std::string> cohortPictureNames(const std::vector<std::string>& cases);

/// Draws them into `folder`, which is there: the overlap on the target liver (thesis Fig. IV.3), and for each
/// case (thesis Figs. IV.5 to IV.7) the scan as registered, its signed distance and curvature difference on
/// its own surface, and the signed distance on the target. All maps of a metric share one range of colours.
[[nodiscard]] std::vector<PictureFile> saveCohortPictures(const CohortOutcome& outcome,
                                                          const std::filesystem::path& folder,
                                                          const Progress& progress);

}  // namespace falciform::commandline
