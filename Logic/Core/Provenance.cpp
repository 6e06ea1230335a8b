#include "Logic/Core/Provenance.h"

#include <ctime>

#include "Version.h"

namespace falciform {

std::string utcNow() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

nlohmann::json toJson(const Provenance& provenance) {
  nlohmann::json inputs = nlohmann::json::array();
  for (const auto& [file, digest] : provenance.inputSha256)
    inputs.push_back({{"file", file}, {"sha256", digest}});
  return {{"program", "falciform"},
          {"version", kVersion},
          {"started_utc", provenance.startedUtc},
          {"command", provenance.command},
          {"seed", provenance.seed},
          {"threads", provenance.threads},
          {"inputs", inputs},
          {"warnings", provenance.warnings},
          {"notice", kResearchUse}};
}

}  // namespace falciform
