#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace falciform::bench {

/// A program from its start to its end, as its user waits for it.
struct ChildRun {
  int exitCode = -1;
  double wallS = 0, cpuS = 0, peakMb = 0;
};

/// Runs `words` in `folder`, output to `folder`/log. Throws std::runtime_error if it cannot be started.
[[nodiscard]] ChildRun runChild(const std::vector<std::string>& words, const std::filesystem::path& folder);

}  // namespace falciform::bench
