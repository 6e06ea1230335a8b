#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace falciform {

/// How a result came to be: what every JSON sidecar carries. No patient identity ever.
struct Provenance {
  std::string command;     ///< the command line as typed, or "window"
  std::string startedUtc;  ///< ISO 8601
  std::uint64_t seed = 0;
  int threads = 0;
  std::vector<std::pair<std::string, std::string>> inputSha256;  ///< file name (no folders) and digest
  std::vector<std::string> warnings;
};

/// Now, "2026-11-22T05:46:58Z".
[[nodiscard]] std::string utcNow();

/// {"program", "version", "started_utc", "command", "seed", "threads", "inputs", "warnings", "notice"}.
[[nodiscard]] nlohmann::json toJson(const Provenance& provenance);

}  // namespace falciform
