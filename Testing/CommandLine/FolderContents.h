#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "Testing/CommandLine/Program.h"

namespace falciform::test {

/// Every file and folder below, hidden ones too, with its bytes (folders: empty).
[[nodiscard]] std::map<std::string, std::string> contentsOf(const std::filesystem::path& folder);

/// Runs and expects exit code 2, one line on stderr that starts with "falciform: " and holds `mention`, and
/// `folder` as it was before.
void expectRefusal(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                   const std::string& mention, const RunOptions& options = {});

}  // namespace falciform::test
