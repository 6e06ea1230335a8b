#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Acquisition/VirtualScanner.h"
#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/Program.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const Surface& liver() {
  static const Surface made = [] {
    SyntheticLiverSettings settings;
    settings.edgeLengthMm = 5;
    Surface surface = makeSyntheticLiver(settings).surface;
    surface.patch.clear();
    return surface;
  }();
  return made;
}

class SuggestCommand : public testing::Test {
 protected:
  SuggestCommand() { writeSurface(at("liver.vtp"), liver(), Overwrite::Refuse); }
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }
  TemporaryFolder folder_;
};

TEST_F(SuggestCommand, PaintsBothFeaturesAndListsTheCandidates) {
  const Ran ran =
      falciform({"suggest", at("liver.vtp"), "--out", at("painted.vtp"), "--picture", at("p.png")});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  const Surface painted = readSurface(at("painted.vtp")).value;
  EXPECT_FALSE(pointsOfPatch(painted, patch::kFalciform).empty());
  EXPECT_FALSE(pointsOfPatch(painted, patch::kInferiorRidge).empty());
  const json sidecar = json::parse(readTextFile(at("painted.vtp.json")));
  const json& ridges = sidecar["figures"]["ridge_candidates"];
  ASSERT_GE(ridges.size(), 2U);
  EXPECT_EQ(ridges[0]["what"], "inferior ridge");
  EXPECT_EQ(ridges[0]["score"], sidecar["figures"]["ridge_score"]);
  EXPECT_GT(ridges[1]["length_mm"].get<double>(), ridges[0]["length_mm"].get<double>());
  EXPECT_TRUE(std::filesystem::exists(at("p.png")));
}

TEST_F(SuggestCommand, PaintsTheCandidateThatIsAskedForAndNothingElse) {
  ASSERT_EQ(falciform({"suggest", at("liver.vtp"), "--out", at("one.vtp"), "--feature", "ridge"}).exitCode,
            0);
  ASSERT_EQ(falciform({"suggest", at("liver.vtp"), "--out", at("two.vtp"), "--feature", "ridge",
                       "--ridge-candidate", "2"})
                .exitCode,
            0);
  const Surface one = readSurface(at("one.vtp")).value, two = readSurface(at("two.vtp")).value;
  EXPECT_TRUE(pointsOfPatch(one, patch::kFalciform).empty());
  EXPECT_GT(pointsOfPatch(two, patch::kInferiorRidge).size(),
            pointsOfPatch(one, patch::kInferiorRidge).size());
}

TEST_F(SuggestCommand, AnotherFrameIsToldByThreeLetters) {
  Surface ras = liver();
  ras.points.leftCols(2) *= -1;
  writeSurface(at("ras.vtp"), ras, Overwrite::Refuse);
  ASSERT_EQ(falciform({"suggest", at("liver.vtp"), "--out", at("a.vtp")}).exitCode, 0);
  ASSERT_EQ(falciform({"suggest", at("ras.vtp"), "--out", at("b.vtp"), "--frame", "RAS"}).exitCode, 0);
  EXPECT_EQ(readSurface(at("a.vtp")).value.patch, readSurface(at("b.vtp")).value.patch);
}

TEST_F(SuggestCommand, SaysWhatIsWrongInOneLineAndWritesNothing) {
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"--frame", "LLS"}, {"--feature", "nose"}, {"--groove-candidate", "5"}}) {
    std::vector<std::string> words{"suggest", at("liver.vtp"), "--out", at("out.vtp")};
    words.insert(words.end(), wrong.begin(), wrong.end());
    const Ran ran = falciform(words);
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, HasSubstr(wrong[0] == "--frame" ? "LLS" : wrong[1]));
    EXPECT_FALSE(std::filesystem::exists(at("out.vtp")));
  }
}

TEST_F(SuggestCommand, PatchesArePaintedByTheStylusAndTheColours) {
  VirtualScannerSettings scanner;
  scanner.stride = 6;
  scanner.elevationDeg = 0;
  SyntheticLiverSettings settings;
  settings.edgeLengthMm = 4;
  Surface scan = scanSurface(makeSyntheticLiver(settings).surface, scanner).scan;
  const std::vector<int> truth = pointsOfPatch(scan, patch::kFalciform);
  // The tip is drawn over every fifth point of the ligament, in their order down the raster.
  std::string csv = "x,y,z\n";
  for (std::size_t i = 0; i < truth.size(); i += 5)
    csv += std::to_string(scan.points(truth[i], 0)) + "," + std::to_string(scan.points(truth[i], 1)) + "," +
           std::to_string(scan.points(truth[i], 2)) + "\n";
  writeTextFile(at("swab.csv"), Overwrite::Refuse, csv);
  scan.patch.clear();
  writeSurface(at("scan.vtp"), scan, Overwrite::Refuse);
  const Ran ran = falciform({"patches", "--to", at("scan.vtp"), "--swab", at("swab.csv"),
                             "--refine-by-colour", "--out", at("painted.vtp")});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  const std::vector<int> found = pointsOfPatch(readSurface(at("painted.vtp")).value, patch::kFalciform);
  std::vector<int> both;
  std::set_intersection(found.begin(), found.end(), truth.begin(), truth.end(), std::back_inserter(both));
  EXPECT_GT(2.0 * static_cast<double>(both.size()), 0.85 * static_cast<double>(found.size() + truth.size()));
  EXPECT_THAT(ran.out, HasSubstr("points used"));
}

}  // namespace
}  // namespace falciform::test
