#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "Logic/Acquisition/ScanPreparation.h"
#include "Logic/IO/ImageFiles.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/Program.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;

/// A sheet of 100 x 100 mm with a photograph on it: liver left of x = 60, gauze right of it.
Surface photographedSheet() {
  Surface sheet = grid(100, 100);
  ColourImage photograph{200, 200, {}};
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x)
      for (const int c : x < 120 ? std::array{146, 68, 56} : std::array{214, 190, 182})
        photograph.rgb.push_back(static_cast<std::uint8_t>(c));
  sheet.textureAt = (sheet.points.leftCols<2>() / 100).cast<float>();
  sheet.texture = std::make_shared<const ColourImage>(std::move(photograph));
  sheet.frame = "scanner";
  return sheet;
}

class ScanCommand : public testing::Test {
 protected:
  ScanCommand() { writeSurface(at("raw.vtp"), photographedSheet(), Overwrite::Refuse); }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  std::vector<std::string> words(std::vector<std::string> more = {}) const {
    std::vector<std::string> all{"scan", at("raw.vtp"), "--out", at("scan.vtp")};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  TemporaryFolder folder_;
};

TEST_F(ScanCommand, WritesTheLibrarysScanWithItsTextureCountsAndPicture) {
  const Ran ran = falciform(words({"--marked", at("marked.vtp"), "--picture", at("scan.png")}));
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  const MarkedScan marked = markScan(readSurface(at("raw.vtp")).value, Points(0, 3), std::nullopt, {});
  const Surface expected = finishScan(marked, {}), written = readSurface(at("scan.vtp")).value;
  EXPECT_EQ(written.points, expected.points);
  EXPECT_EQ(written.triangles, expected.triangles);
  EXPECT_EQ(written.frame, "scanner");
  ASSERT_TRUE(written.texture);
  EXPECT_EQ(written.texture->rgb, photographedSheet().texture->rgb);
  const nlohmann::json figures = readJsonFile(at("scan.vtp.json"))["figures"];
  EXPECT_EQ(figures["points_read"], 101 * 101);
  EXPECT_EQ(figures["other_tissue"], marked.count(ScanMark::OtherTissue));
  EXPECT_EQ(figures["points_written"], expected.size());
  EXPECT_EQ(figures["seed_found_by_itself"], true);
  EXPECT_EQ(readSurface(at("marked.vtp")).value.arrays.at("scan_mark").maxCoeff(), 4);
  const ColourImage picture = readColourImage(at("scan.png"));
  EXPECT_GT(picture.width, 2 * picture.height) << "three beside each other";
  EXPECT_THAT(ran.out, HasSubstr("other tissue"));
}

TEST_F(ScanCommand, SeedsUnitAndSpacingAreTaken) {
  Surface metres = photographedSheet();
  metres.points *= 1e-3;
  writeSurface(at("metres.ply"), metres, Overwrite::Refuse);
  const Ran ran = falciform(
      {"scan", at("metres.ply"), "--out", at("thin.ply"), "--seed", "80,50,0", "--spacing", "4", "--smooth"});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("taken for m "));
  const nlohmann::json figures = readJsonFile(at("thin.ply.json"))["figures"];
  EXPECT_EQ(figures["unit_factor"], 1000);
  EXPECT_NEAR(figures["seeds_mm"][0][0].get<double>(), 80, 1);
  EXPECT_NEAR(figures["spacing_mm"].get<double>(), 5, 1);  // neighbours stand one to two spacings apart
  EXPECT_GT(readSurface(at("thin.ply")).value.points.col(0).minCoeff(), 55);
}

TEST_F(ScanCommand, ADepthFrameIsPreparedWithTheCameraGiven) {
  DepthImage depths{60, 50, std::vector<std::uint16_t>(3000, 400)};
  writePng(at("frame.png"), depths, Overwrite::Refuse);
  const std::vector<std::string> all{"scan", at("frame.png"), "--out", at("scan.vtp"), "--no-extract"};
  expectRefusal(all, folder_.path(), "frame.json");
  writeTextFile(at("kinect.txt"), Overwrite::Refuse, "200 200 29.5 24.5\n");
  std::vector<std::string> more = all;
  more.insert(more.end(), {"--camera", at("kinect.txt")});
  const Ran ran = falciform(more);
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  EXPECT_EQ(readSurface(at("scan.vtp")).value.size(), 3000);
}

TEST_F(ScanCommand, MistakesAreOneLineAndWriteNothing) {
  expectRefusal(words({"--seed", "50,50"}), folder_.path(), "x,y,z");
  expectRefusal(words({"--seed", "500,50,0"}), folder_.path(), "give a place on it");
  expectRefusal(words({"--scanner-at", "up"}), folder_.path(), "x,y,z");
  expectRefusal(words({"--camera", at("raw.vtp")}), folder_.path(), "no depth frame");
  expectRefusal(words({"--unit", "inch"}), folder_.path(), "mm");
}

}  // namespace
}  // namespace falciform::test
