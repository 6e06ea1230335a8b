#include <gmock/gmock.h>

#include <limits>

#include "Logic/IO/ResultFiles.h"
#include "Testing/Logic/IO/ResultSamples.h"
#include "Testing/Logic/IO/SurfaceSamples.h"

namespace falciform {
namespace {

using namespace test;
using nlohmann::json;

TEST(RegistrationJson, ComesBackThroughTextAsItWas) {
  const RegistrationResult result = sampleRegistration();
  const json written = toJson(result);
  EXPECT_EQ(toJson(registrationFromJson(json::parse(written.dump()))), written);
  const RegistrationResult read = registrationFromJson(json::parse(written.dump()));
  EXPECT_EQ(read.scanFromPreop.matrix(), result.scanFromPreop.matrix());
  EXPECT_EQ(read.patchRmsMm, result.patchRmsMm);
  EXPECT_EQ(read.warnings, result.warnings);
  ASSERT_EQ(read.history.size(), 2u);
  EXPECT_EQ(read.history[1].motionMm, result.history[1].motionMm);
  ASSERT_EQ(read.basins.size(), 1u);
  EXPECT_EQ(read.basins[0].starts, 7);
}

TEST(RegistrationJson, NotANumberIsNullAndComesBackAsSuch) {
  RegistrationResult result = sampleRegistration();
  result.rmsMm = std::numeric_limits<double>::quiet_NaN();
  result.p95Mm = std::numeric_limits<double>::infinity();
  const json written = toJson(result);
  EXPECT_TRUE(written["rms_mm"].is_null());
  EXPECT_TRUE(written["p95_mm"].is_null());
  EXPECT_TRUE(std::isnan(registrationFromJson(written).rmsMm));
}

TEST(RegistrationJson, AMissingOrWrongKeyIsNamed) {
  const auto refusal = [](const json& bad) { return refusalOf([&] { (void)registrationFromJson(bad); }); };
  const json good = toJson(sampleRegistration());
  for (const auto& [key, unused] : good.items()) {
    if (key == "direction" || key == "note") continue;  // words for the reader
    json bad = good;
    bad.erase(key);
    EXPECT_THAT(refusal(bad), testing::HasSubstr(key));
    bad[key] = true;  // the wrong kind for all but one
    if (key != "converged") {
      EXPECT_THAT(refusal(bad), testing::HasSubstr(key));
    }
  }
  EXPECT_NE(refusal(json::array()), "no error");
}

TEST(DistanceJson, StatesUnitsAndComesBack) {
  const DistanceMap map = sampleDistance();
  const json written = toJson(map);
  EXPECT_EQ(written["preop"]["all"]["mean_mm"], 1.25);
  EXPECT_EQ(written["preop"]["patches"][1]["patch"], "hilum, left");
  EXPECT_TRUE(written["scan"]["all"]["median_mm"].is_null());
  EXPECT_EQ(toJson(distanceFromJson(json::parse(written.dump()), map.preop, map.scan)), written);
}

TEST(DistanceCsv, HasARowPerSideAndPatchAndQuotesNames) {
  EXPECT_EQ(toCsv(sampleDistance()),
            "side,patch,count,mean_mm,sd_mm,median_mm,p95_absolute_mm,min_mm,max_mm,rms_mm,mean_absolute_mm\n"
            "preop,all,4,1.25,0.5,1,2,-1,2.5,1.5,1.1\n"
            "preop,falciform,2,1.25,0.5,1,2,-1,2.5,1.5,1.1\n"
            "preop,\"hilum, left\",2,1.25,0.5,1,2,-1,2.5,1.5,1.1\n"
            "scan,all,0,,,,,,,,\n");
}

}  // namespace
}  // namespace falciform
