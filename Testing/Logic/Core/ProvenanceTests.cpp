#include "Logic/Core/Provenance.h"

#include <gtest/gtest.h>

#include <regex>

namespace falciform {

TEST(Provenance, TimeIsIso8601InUtc) {
  EXPECT_TRUE(std::regex_match(utcNow(), std::regex(R"(20\d\d-[01]\d-[0-3]\dT[0-2]\d:[0-5]\d:[0-6]\dZ)")))
      << utcNow();
}

TEST(Provenance, SidecarSaysHowAResultCameToBe) {
  Provenance provenance;
  provenance.command = "falciform register --case x";
  provenance.startedUtc = "2026-01-02T03:04:05Z";
  provenance.seed = 18446744073709551615U;
  provenance.threads = 2;
  provenance.inputSha256 = {{"scan.ply", "abc"}};
  provenance.warnings = {"no space tag"};
  const auto json = nlohmann::json::parse(toJson(provenance).dump());
  EXPECT_EQ(json["program"], "falciform");
  EXPECT_FALSE(json["version"].get<std::string>().empty());
  EXPECT_EQ(json["command"], provenance.command);
  EXPECT_EQ(json["started_utc"], provenance.startedUtc);
  EXPECT_EQ(json["seed"].get<std::uint64_t>(), provenance.seed) << "all 64 bits";
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["inputs"][0]["file"], "scan.ply");
  EXPECT_EQ(json["inputs"][0]["sha256"], "abc");
  EXPECT_EQ(json["warnings"][0], "no space tag");
  EXPECT_NE(json["notice"].get<std::string>().find("Research use only"), std::string::npos);
}

}  // namespace falciform
