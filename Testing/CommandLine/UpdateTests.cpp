// `falciform update`, on the built-in liver packed by elasticity: what a user types, and what stands in the
// folder.

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "Logic/Geometry/Measures.h"
#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/Program.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;

nlohmann::json jsonOf(const std::string& file) {
  std::ifstream stream(file);
  return nlohmann::json::parse(stream);
}

class UpdateCommand : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  void pack(const std::string& mm) const {
    // Packed on a mesh finer than the update's.
    const Ran ran = falciform({"synthesise", "--out", at("case"), "--packing", mm, "--packed-edge-length",
                               "12", "--edge-length", "3", "--voxel", "4"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
  }
  std::vector<std::string> words() const {
    return {"update",  "--preop",           at("case/preop_painted.vtp"),
            "--scan",  at("case/scan.vtp"), "--out",
            at("out"), "--edge-length",     "16"};
  }
  std::vector<std::string> words(const std::vector<std::string>& more) const {
    std::vector<std::string> all = words();
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  TemporaryFolder folder_;
};

TEST_F(UpdateCommand, APackedLiverComesNearerThanItsRegistrationBringsIt) {
  ASSERT_NO_FATAL_FAILURE(pack("15"));
  const Ran ran = falciform(
      words({"--targets", at("case/targets.mrk.json"), "--truth-targets", at("case/truth_targets.mrk.json"),
             "--structures", at("case/structures/tumour_1.vtp")}));
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  const nlohmann::json figures = jsonOf(at("out/update.json")).at("figures");
  const nlohmann::json error = figures.at("target_error");
  // mm; the packed lobe is seen, its underside is not: a third of what the rigid pose leaves must go.
  EXPECT_LT(error.at("mean_mm").get<double>(), 0.75 * error.at("start_mean_mm").get<double>());
  EXPECT_GT(figures.at("min_det_j").get<double>(), 0.5);
  const Surface before = readSurface(at("case/preop_painted.vtp")).value,
                after = readSurface(at("out/updated.vtp")).value;
  EXPECT_EQ(after.size(), before.size());
  EXPECT_EQ(after.frame, readSurface(at("case/scan.vtp")).value.frame);
  EXPECT_NEAR(signedVolume(after) / signedVolume(before), 1, 0.03);  // tissue hardly changes its volume
  EXPECT_EQ(after.arrays.count("displacement_mm") + after.arrays.count("expected_error_mm"), 2U);
  EXPECT_EQ(readLandmarks(at("out/targets_updated.mrk.json")).value.points.size(),
            readLandmarks(at("case/targets.mrk.json")).value.points.size());
  const Surface tumour = readSurface(at("out/tumour_1_updated.vtp")).value;
  EXPECT_NEAR(signedVolume(tumour) / signedVolume(readSurface(at("case/structures/tumour_1.vtp")).value), 1,
              0.1);
}

TEST_F(UpdateCommand, MistakesAreToldInOneLineAndLeaveNothing) {
  ASSERT_NO_FATAL_FAILURE(pack("0"));  // not packed: made sooner
  expectRefusal(words({"--truth-targets", at("case/truth_targets.mrk.json")}), folder_.path(),
                "without --targets");
  expectRefusal(words({"--picture", at("out/update.jpg")}), folder_.path(), ".png");
  expectRefusal(words({"--max-bend", "0"}), folder_.path(), "max-bend");
}

}  // namespace
}  // namespace falciform::test
