#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Deformation/DistanceMapping.h"
#include "Widgets/Rendering/MappedCase.h"

namespace falciform {

/// Maps read from disk, and what was left out.
struct CaseMaps {
  std::vector<MappedCase> cases;
  std::vector<std::string> warnings;
};

/// What a folder holds to be compared: itself if it is a case, else the cases and result folders of
/// `falciform distance` in it, the cases in what `falciform cohort` wrote, else its surfaces that carry
/// values. Sorted as people count: 2 before 10. Throws InputError if there is nothing.
[[nodiscard]] std::vector<std::filesystem::path> mapSourcesIn(const std::filesystem::path& folder);

/// Reads each source's distance map; that of a case which has none is computed from its registration, by
/// `settings`. What cannot be read is left out with a warning. Throws InputError if nothing is left.
[[nodiscard]] CaseMaps loadCaseMaps(const std::vector<std::filesystem::path>& sources,
                                    const DistanceSettings& settings, const Progress& progress = {});

}  // namespace falciform
