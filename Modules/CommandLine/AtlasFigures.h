#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "Logic/Atlas/Atlas.h"
#include "Logic/Atlas/LoadFiles.h"
#include "Modules/CommandLine/Arguments.h"

namespace falciform::commandline {

/// Counts, rank, energy, largest figures over the members.
[[nodiscard]] nlohmann::json atlasFigures(const Atlas& atlas);
/// The same in words.
[[nodiscard]] std::vector<std::string> atlasLines(const Atlas& atlas);
/// The same of surface loads.
[[nodiscard]] nlohmann::json loadFigures(const LoadAtlas& atlas);
[[nodiscard]] std::vector<std::string> loadLines(const LoadAtlas& atlas);
/// What a user should know before relying on it.
[[nodiscard]] std::vector<std::string> atlasWarnings(const Atlas& atlas);
/// One line a setup: what holds it and what is pushed where.
[[nodiscard]] std::vector<std::string> setupLines(const Atlas& atlas);
/// A head and one line a member.
[[nodiscard]] std::vector<std::string> memberLines(const Atlas& atlas);
/// What 3D Slicer is told.
[[nodiscard]] std::vector<ResultField> atlasResultFields();

}  // namespace falciform::commandline
