#include <gmock/gmock.h>

#include <limits>

#include "Logic/Core/Errors.h"
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

TEST(DistanceJson, OfACaseSavedBeforeRegionsWereGivesWhatItKnows) {
  const DistanceMap map = sampleDistance();
  json old = toJson(map);
  old["preop"].erase("regions");
  const DistanceMap read = distanceFromJson(old, map.preop, map.scan);
  ASSERT_EQ(read.preopRegions.size(), 3U);  // all, two patches
  EXPECT_EQ(read.preopRegions[2].name, "hilum, left");
  EXPECT_EQ(read.preopRegions[2].distance.mean, 1.25);
  EXPECT_TRUE(std::isnan(read.preopRegions[0].areaMm2));
  old["scan"]["regions"][0]["kind"] = "lobe";
  EXPECT_THROW((void)distanceFromJson(old, map.preop, map.scan), InputError);
}

TEST(DistanceCsv, HasARowPerSideAndRegionAndQuotesNames) {
  EXPECT_EQ(toCsv(sampleDistance()),
            "side,region,kind,area_mm2,covered_area_mm2,coverage,"
            "count,mean_mm,sd_mm,median_mm,p95_absolute_mm,min_mm,max_mm,rms_mm,mean_absolute_mm,"
            "curvature_difference_count,curvature_difference_mean_per_mm,curvature_difference_sd_per_mm,"
            "curvature_difference_median_per_mm,curvature_difference_p95_absolute_per_mm,"
            "curvature_difference_min_per_mm,curvature_difference_max_per_mm,"
            "curvature_difference_rms_per_mm,curvature_difference_mean_absolute_per_mm\n"
            "preop,all,all,100,50,0.5,4,1.25,0.5,1,2,-1,2.5,1.5,1.1,"
            "3,0.25,0.125,0.25,0.5,-0.5,0.75,0.5,0.375\n"
            "preop,\"hilum, left\",patch,20,20,1,2,1.25,0.5,1,2,-1,2.5,1.5,1.1,0,,,,,,,,\n"
            "preop,segment IV,segment,40,0,0,0,,,,,,,,,0,,,,,,,,\n"
            "scan,all,all,,,0,0,,,,,,,,,0,,,,,,,,\n");
}

}  // namespace
}  // namespace falciform
