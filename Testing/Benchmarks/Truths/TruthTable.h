#pragma once
#include <filesystem>
#include <string>

namespace falciform::bench {

/// The cases of a folder that writeTruth wrote, one row each, and their means, as Markdown: what was drawn,
/// how far the targets went and what the scan saw of it. Throws InputError for a folder without cases.
[[nodiscard]] std::string truthTable(const std::filesystem::path& cases);

}  // namespace falciform::bench
