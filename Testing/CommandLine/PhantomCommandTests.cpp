#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "Logic/IO/CaseFolder.h"
#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/Support/TemporaryFolder.h"
#include "Widgets/Rendering/RenderedImage.h"

namespace falciform::test {
namespace {

std::vector<std::string> phantomCall(const std::filesystem::path& out, std::vector<std::string> more = {}) {
  std::vector<std::string> words{"synthesise",    "--kind", "phantom",  "--out", out.string(), "--voxel", "4",
                                 "--edge-length", "5",      "--stride", "3"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(PhantomCommand, WritesACaseWhoseFilesAgreeWithItsTruth) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder / "phantom";
  const Ran ran = falciform(phantomCall(out));
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  EXPECT_THAT(ran.out, testing::HasSubstr("FRE"));

  const Isometry3d truth = readTransform(out / "truth_scan_from_preop.tfm"),
                   gold = readTransform(out / "gold_scan_from_preop.tfm");
  const Landmarks targets = readLandmarks(out / "targets.mrk.json").value,
                  trueTargets = readLandmarks(out / "truth_targets.mrk.json").value,
                  spheresCt = readLandmarks(out / "spheres_ct.mrk.json").value,
                  spheresScan = readLandmarks(out / "spheres_scan.mrk.json").value;
  ASSERT_EQ(targets.points.size(), trueTargets.points.size());
  for (std::size_t i = 0; i < targets.points.size(); ++i) {
    const Vector3d there = trueTargets.points[i].position;
    EXPECT_LT((truth * targets.points[i].position - there).norm(), 1e-4);  // mm: digits in the files
    EXPECT_LT((gold * targets.points[i].position - there).norm(), 0.5);    // mm: rough voxels, few returns
  }
  ASSERT_EQ(spheresCt.points.size(), 7u);
  for (std::size_t s = 0; s < 7; ++s)
    EXPECT_LT((truth * spheresCt.points[s].position - spheresScan.points[s].position).norm(), 0.5);  // mm

  const Surface preop = readSurface(out / "preop.vtp").value, scan = readSurface(out / "scan.vtp").value;
  for (const Surface& painted : {preop, scan, readSurface(out / "scan_subregion.vtp").value})
    EXPECT_THAT(patchLabels(painted), testing::ElementsAre(patch::kFalciform, patch::kInferiorRidge));
  EXPECT_EQ(patchName(readSurface(out / "scan_whole_view.vtp").value, patch::kFirstNamed), "sphere 1");
  EXPECT_EQ(readImage(out / "ct.nii.gz").value.size, readLabelMap(out / "labelmap.nii.gz").value.size);
  EXPECT_EQ(readCaseDescription(out).preop, "preop.vtp");

  for (const char* name : {"scan.png", "scan_subregion.png", "preop.png"}) {
    const RenderedImage picture = readPng(out / "pictures" / name);
    std::set<std::array<int, 3>> colours;
    for (int y = 0; y < picture.height; y += 3)
      for (int x = 0; x < picture.width; x += 3) colours.insert(picture.at(x, y));
    EXPECT_GT(colours.size(), 100u) << name;  // an empty one holds background and text
  }

  const auto sidecar = nlohmann::json::parse(readTextFile(out / "synthesise.json"));
  EXPECT_EQ(sidecar["figures"]["scan"]["points"], scan.size());
  EXPECT_EQ(sidecar["figures"]["preop"]["points"], preop.size());
  EXPECT_EQ(sidecar["figures"]["spheres"].size(), 7u);
  EXPECT_LT(sidecar["figures"]["fre_mm"].get<double>(), 0.3);
  EXPECT_EQ(sidecar["settings"]["scanner"]["stride"], 3);       // as given
  EXPECT_EQ(sidecar["settings"]["scanner"]["windowShare"], 1);  // the phantom's own
}

TEST(PhantomCommand, FollowsTheSeed) {
  const TemporaryFolder folder;
  ASSERT_EQ(falciform(phantomCall(folder / "a")).exitCode, 0);
  ASSERT_EQ(falciform(phantomCall(folder / "b", {"--threads", "1"})).exitCode, 0);
  ASSERT_EQ(falciform(phantomCall(folder / "c", {"--seed", "7"})).exitCode, 0);
  for (const char* name : {"scan.vtp", "preop.vtp", "gold_scan_from_preop.tfm"}) {
    EXPECT_TRUE(readTextFile(folder / "a" / name) == readTextFile(folder / "b" / name)) << name;
    EXPECT_FALSE(readTextFile(folder / "a" / name) == readTextFile(folder / "c" / name)) << name;
  }
}

TEST(PhantomCommand, ABusyRoomGivesARawScanWithItsPhotographBesideTheOrgansOwn) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder / "room";
  const Ran ran =
      falciform({"synthesise", "--out", out.string(), "--edge-length", "6", "--voxel", "6", "--stride", "6",
                 "--drape", "--instruments", "2", "--smoke", "0.02", "--photograph"});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  const Surface raw = readSurface(out / "scan_raw.vtp").value, organ = readSurface(out / "scan.vtp").value;
  const VectorXd& source = raw.arrays.at("structure");
  for (const int structure : {0, 1, 2, 3}) EXPECT_TRUE((source.array() == structure).any()) << structure;
  EXPECT_EQ(organ.size(), (source.array() == 0).count());
  EXPECT_FALSE(organ.arrays.contains("structure"));
  for (const Surface& scan : {raw, organ}) {
    ASSERT_TRUE(scan.texture);
    EXPECT_EQ(scan.texture->width, 1280);
  }
}

TEST(PhantomCommand, RefusesWhatBelongsToTheOtherKind) {
  const TemporaryFolder folder;
  const std::string out = (folder / "out").string();
  expectRefusal({"synthesise", "--out", out, "--kind", "phantom", "--deformation", "3"}, folder.path(),
                "--deformation");
  expectRefusal({"synthesise", "--out", out, "--sphere-radius", "9"}, folder.path(), "--sphere-radius");
  expectRefusal({"synthesise", "--out", out, "--kind", "ghost"}, folder.path(), "liver or phantom");
  expectRefusal({"synthesise", "--out", out, "--kind", "phantom", "--window-share", "0.2", "--voxel", "5",
                 "--edge-length", "8"},
                folder.path(), "sphere 1");
}

}  // namespace
}  // namespace falciform::test
