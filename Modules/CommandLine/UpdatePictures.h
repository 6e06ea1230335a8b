#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "Modules/CommandLine/CaseUpdate.h"
#include "Widgets/Rendering/Pictures.h"

namespace falciform::commandline {

/// Names of all that saveUpdatePictures may write.
[[nodiscard]] const std::vector<std::string>& updatePictureNames();

/// Pictures of a case's update for its report, into `folder`, which is there: the liver registered and
/// updated, the expected error, the scan's distance before and after, what is inside, and, where there is a
/// CT, a cut through it as it was and as it would look now.
[[nodiscard]] std::vector<PictureFile> saveUpdatePictures(const CaseUpdate& update,
                                                          const DistanceMap& registered,
                                                          const Structures& structures, const BentCt& ct,
                                                          const std::filesystem::path& folder,
                                                          const Progress& progress);

}  // namespace falciform::commandline
