#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "Logic/Deformation/DistanceMapping.h"
#include "Modules/CommandLine/Commands.h"

namespace falciform::commandline {

// What `distance` and `run` share.

/// preop_distance.vtp, scan_distance.vtp, distance.csv.
[[nodiscard]] std::vector<std::string> distanceFiles();
/// Writes them into `folder`, where they were announced, and says in which frame they are.
void writeDistance(const DistanceMap& map, const std::filesystem::path& folder, CommandRun& run);
[[nodiscard]] nlohmann::json distanceFigures(const DistanceMap& map);
void tellDistance(const DistanceMap& map, CommandRun& run);

}  // namespace falciform::commandline
