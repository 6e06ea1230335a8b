#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "Logic/IO/JsonFile.h"
#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Logic/Segmentation/LevelSet.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/Program.h"
#include "Testing/Logic/Segmentation/PaintedCt.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;

class SegmentCommand : public testing::Test {
 protected:
  SegmentCommand() { writeImage(at("ct.nrrd"), ct_, Overwrite::Refuse); }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  std::vector<std::string> words(const std::string& seed, std::vector<std::string> more = {}) const {
    std::vector<std::string> all{"segment", at("ct.nrrd"),    "--seed",         seed,
                                 "--out",   at("organ.nrrd"), "--least-volume", "0"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  TemporaryFolder folder_;
  Image ct_ = paintedCt({40, 40, 30}, {2.5, 2.5, 3}, 10, 7, [](const Vector3d& p) {
    return (p - Vector3d(50, 50, 45)).norm() < 28 ? 100.0 : -90.0;
  });
};

TEST_F(SegmentCommand, WritesTheLibrarysLabelsWithASidecarAndAPicture) {
  const Ran ran = falciform(words("50,50,45; 45,60,40", {"--picture", at("organ.png")}));
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  LevelSetSettings settings;
  settings.leastVolumeMl = 0;
  Points seeds(2, 3);
  seeds << 50, 50, 45, 45, 60, 40;
  const LevelSetResult expected = segmentLevelSet({.ct = ct_, .seeds = seeds}, settings);
  EXPECT_EQ(readLabelMap(at("organ.nrrd")).value.voxels, expected.labels.voxels);
  const nlohmann::json sidecar = readJsonFile(at("organ.nrrd.json"));
  EXPECT_EQ(sidecar["figures"]["volume_ml"].get<double>(), expected.volumeMl);
  EXPECT_EQ(sidecar["settings"]["seedsLpsMm"].size(), 2u);
  EXPECT_TRUE(std::filesystem::exists(at("organ.png")));
  EXPECT_THAT(ran.out, HasSubstr(" ml of 100 +- "));
}

TEST_F(SegmentCommand, SeedsFromAFileAndGoingOnFromALabelMap) {
  writeLandmarks(at("seeds.mrk.json"), {{{"a", {50, 50, 45}}}, "LPS"}, Overwrite::Refuse);
  const Ran first = falciform({"segment", at("ct.nrrd"), "--seeds", at("seeds.mrk.json"), "--out",
                               at("first.nrrd"), "--least-volume", "0"});
  ASSERT_EQ(first.exitCode, 0) << first.err;
  const Ran second = falciform({"segment", at("ct.nrrd"), "--continue", at("first.nrrd"), "--out",
                                at("second.nrrd"), "--least-volume", "0"});
  ASSERT_EQ(second.exitCode, 0) << second.err;
  EXPECT_GT(dice(readLabelMap(at("first.nrrd")).value, readLabelMap(at("second.nrrd")).value), 0.98);
}

TEST_F(SegmentCommand, MistakesAreOneLineAndWriteNothing) {
  expectRefusal(words("50,50"), folder_.path(), "x,y,z");
  expectRefusal(words("50,50,nan"), folder_.path(), "x,y,z");
  expectRefusal(words("50,50,450"), folder_.path(), "outside the volume");
  expectRefusal(words(""), folder_.path(), "seed");
}

}  // namespace
}  // namespace falciform::test
