#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "Logic/Atlas/UpdateMap.h"
#include "Modules/CommandLine/CommandRun.h"

namespace falciform::commandline {

/// tool_tips_preop.mrk.json and .csv.
[[nodiscard]] std::vector<std::string> toolTipFiles();

/// Reads `file` (.mrk.json, .fcsv, or a table .csv, .xyz: scan mm) and writes into `folder`, where they were
/// announced, where these points are in the pre-op CT, `preopFrame`; the table says as well which lie in the
/// liver and how far outside the others are.
void writeToolTips(const std::filesystem::path& file, const UpdateMap& map, const std::string& preopFrame,
                   const std::filesystem::path& folder, CommandRun& run);

}  // namespace falciform::commandline
