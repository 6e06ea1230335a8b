#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Atlas/AtlasFiles.h"
#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/Support/TemporaryFolder.h"
#include "Widgets/Rendering/RenderedImage.h"

namespace falciform::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// A coarse liver and a design of 8 places, 24 members, 2 batches of solves.
class AtlasCommand : public testing::Test {
 protected:
  AtlasCommand() {
    static const Surface liver = makeSyntheticLiver({.edgeLengthMm = 6, .voxelMm = 6}).surface;
    writeSurface(folder_ / "liver.vtp", liver, Overwrite::Refuse);
    put("design.json",
        R"({"preset": "thesis-packing", "packing": {"places": 8, "stepMm": 5, "maxPushMm": 15}})");
  }
  void put(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::vector<std::string> build(const std::string& design, const std::string& out,
                                               const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{
        "atlas",   "build",         fs::exists(folder_ / design) ? at(design) : design,
        "--preop", at("liver.vtp"), "--out",
        at(out),   "--edge-length", "24"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  void expectSameBits(const std::string& one, const std::string& other) const {
    const Atlas a = readAtlas(folder_ / one).atlas, b = readAtlas(folder_ / other).atlas;
    EXPECT_EQ(a.coefficients, b.coefficients);
    EXPECT_EQ(a.stiffness, b.stiffness);
    ASSERT_EQ(a.rank(), b.rank());
    for (std::size_t k = 0; k < a.modes.size(); ++k) EXPECT_EQ(a.modes[k], b.modes[k]);
    for (std::size_t m = 0; m < a.figures.size(); ++m) EXPECT_EQ(a.figures[m].minDetJ, b.figures[m].minDetJ);
  }

  TemporaryFolder folder_;
};

TEST_F(AtlasCommand, BuildsTheThesissGravityAtlasAndInfoTellsWhatItHolds) {
  const Ran built = falciform(build("thesis-gravity", "a.h5"));
  ASSERT_EQ(built.exitCode, 0) << built.err;
  EXPECT_THAT(built.out, HasSubstr("121 members of 1 setup, from 3 independent solves"));
  EXPECT_FALSE(fs::exists(folder_ / "a.h5.part"));
  const nlohmann::json sidecar = nlohmann::json::parse(readTextFile(folder_ / "a.h5.json"));
  EXPECT_EQ(sidecar["figures"]["rank"], 3);
  EXPECT_GE(sidecar["figures"]["energy"], 0.99999);
  EXPECT_EQ(sidecar["settings"]["design"]["kind"], "gravityDirections");
  EXPECT_EQ(sidecar["inputs"][0]["file"], "liver.vtp");
  const Ran told = falciform({"atlas", "info", at("a.h5"), "--members"});
  ASSERT_EQ(told.exitCode, 0) << told.err;
  EXPECT_THAT(told.out, HasSubstr("rank 3 holds"));
  EXPECT_THAT(told.out, HasSubstr("setup 0 'on the back': venaCava fixed"));
  EXPECT_EQ(lineCount(told.out), lineCount(falciform({"atlas", "info", at("a.h5")}).out) + 1 + 1 + 121);
}

TEST_F(AtlasCommand, SharedBuildsGiveTheSameBitsInWhateverOrder) {
  ASSERT_EQ(falciform(build("design.json", "one.h5")).exitCode, 0);
  const Ran second = falciform(build("design.json", "two.h5", {"--shard", "1/2"}));
  ASSERT_EQ(second.exitCode, 0) << second.err;
  EXPECT_THAT(second.out, HasSubstr("3 of 8 solves are kept"));
  EXPECT_FALSE(fs::exists(folder_ / "two.h5"));
  const Ran first = falciform(build("design.json", "two.h5", {"--shard", "0/2", "--threads", "1"}));
  ASSERT_EQ(first.exitCode, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("24 members of 8 setups, from 8 independent solves"));
  EXPECT_FALSE(fs::exists(folder_ / "two.h5.part"));
  expectSameBits("one.h5", "two.h5");
  const Ran again = falciform(build("design.json", "two.h5", {"--shard", "1/2"}));
  EXPECT_EQ(again.exitCode, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("is built already"));
}

TEST_F(AtlasCommand, UnderMpirunTheRanksShareTheWorkAndGiveTheSameBits) {
  if (std::system("mpirun --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "needs mpirun (openmpi-bin)";
  ASSERT_EQ(falciform(build("design.json", "one.h5")).exitCode, 0);
  std::string call = "mpirun -n 2 --allow-run-as-root --oversubscribe '" FALCIFORM_EXECUTABLE "'";
  for (const std::string& word : build("design.json", "two.h5")) call += " '" + word + "'";
  ASSERT_EQ(std::system((call + " > '" + at("out") + "' 2>&1").c_str()), 0) << readTextFile(folder_ / "out");
  EXPECT_FALSE(fs::exists(folder_ / "two.h5.part"));
  expectSameBits("one.h5", "two.h5");
}

TEST_F(AtlasCommand, AStoppedBuildGoesOnWhereItStood) {
  ASSERT_EQ(falciform(build("design.json", "one.h5")).exitCode, 0);
  RunOptions stop;
  stop.interruptWhen = [&] { return fs::exists(folder_ / "two.h5.part/solves-0.h5"); };
  const Ran stopped = falciform(build("design.json", "two.h5"), stop);
  if (stopped.exitCode == 0) GTEST_SKIP() << "ended before it could be stopped";
  EXPECT_EQ(stopped.exitCode, 130);
  EXPECT_THAT(stopped.err, HasSubstr("solves are kept in"));
  EXPECT_EQ(lineCount(stopped.err), 1) << stopped.err;
  EXPECT_FALSE(fs::exists(folder_ / "two.h5"));
  EXPECT_FALSE(fs::exists(folder_ / "two.h5.json"));
  const Ran goneOn = falciform(build("design.json", "two.h5"));
  ASSERT_EQ(goneOn.exitCode, 0) << goneOn.err;
  EXPECT_THAT(goneOn.out, HasSubstr("continued: "));
  EXPECT_FALSE(fs::exists(folder_ / "two.h5.part"));
  expectSameBits("one.h5", "two.h5");
}

TEST_F(AtlasCommand, AnotherDesignDoesNotGoOnFromTheFirst) {
  ASSERT_EQ(falciform(build("design.json", "a.h5", {"--shard", "0/2"})).exitCode, 0);
  put("other.json",
      R"({"preset": "thesis-packing", "packing": {"places": 8, "extentMm": 40, "maxPushMm": 15}})");
  expectRefusal(build("other.json", "a.h5"), folder_.path(), "interrupted build with another design");
  const Ran anew = falciform(build("other.json", "a.h5", {"--force"}));
  EXPECT_EQ(anew.exitCode, 0) << anew.err;
  EXPECT_THAT(anew.out, Not(HasSubstr("continued")));
}

TEST_F(AtlasCommand, DrawsTheMembersThatAreAskedFor) {
  ASSERT_EQ(falciform(build("design.json", "a.h5")).exitCode, 0);
  const Ran drawn = falciform({"atlas", "info", at("a.h5"), "--picture", at("sheet.png"), "--show", "2,23"});
  ASSERT_EQ(drawn.exitCode, 0) << drawn.err;
  const RenderedImage sheet = readPng(folder_ / "sheet.png");
  EXPECT_EQ(sheet.width, 3 * 560);  // supports and two members: one row
  EXPECT_EQ(sheet.height, 440);
  // The pushed faces' yellow, of which nothing else in the sheet has much, is on the first tile.
  int yellow = 0;
  for (int y = 40; y < sheet.height; ++y)
    for (int x = 120; x < 560; ++x) {
      const auto [r, g, b] = sheet.at(x, y);
      yellow += r > 130 && g > 100 && b < 60;
    }
  EXPECT_GT(yellow, 500);
  ASSERT_EQ(falciform({"atlas", "info", at("a.h5"), "--picture", at("five.png")}).exitCode, 0);
  EXPECT_EQ(readPng(folder_ / "five.png").height, 2 * 440);
  expectRefusal({"atlas", "info", at("a.h5"), "--picture", at("more.png"), "--show", "24"}, folder_.path(),
                "no member 24 in an atlas of 24");
  expectRefusal({"atlas", "info", at("a.h5"), "--show", "3"}, folder_.path(), "without --picture");
  expectRefusal({"atlas", "info", at("a.h5"), "--picture", at("p.jpg")}, folder_.path(), "written as .png");
}

TEST_F(AtlasCommand, MistakesAreRefusedInOneLine) {
  const fs::path& folder = folder_.path();
  expectRefusal({"atlas"}, folder, "wants a second word: build or info");
  expectRefusal({"atlas", "bild"}, folder, "build or info");
  expectRefusal(build("thesis-gravity", "a.h6"), folder, "an atlas is written as .h5");
  expectRefusal(build("gravity", "a.h5"), folder, "neither a design file nor a preset");
  put("broken.json", "{\"kind\": ");
  expectRefusal(build("broken.json", "a.h5"), folder, "broken.json");
  put("unknown.json", R"({"kind": "packing", "pushes": 3})");
  expectRefusal(build("unknown.json", "a.h5"), folder, "'unknown.json': the design has no key 'pushes'");
  for (const char* shard : {"1", "2/2", "-1/3", "0/0", "a/b"})
    expectRefusal(build("design.json", "a.h5", {"--shard", shard}), folder, "--shard");
  expectRefusal({"atlas", "build", "thesis-gravity", "--out", at("a.h5")}, folder,
                "neither --preop nor --mesh");
  expectRefusal({"atlas", "build", "thesis-gravity", "--out", at("a.h5"), "--mesh", at("m.vtu"), "--tumours",
                 at("liver.vtp")},
                folder, "leave one out");
  put("many.json", R"({"kind": "packing", "packing": {"places": 999}})");
  expectRefusal(build("many.json", "a.h5"), folder, "999 packing sites");
  expectRefusal({"atlas", "info", at("liver.vtp")}, folder, "is no falciform atlas");
  expectRefusal({"atlas", "info", at("none.h5")}, folder, "does not exist");
}

TEST_F(AtlasCommand, LeavesNothingWhereFilesCannotGrow) {
  RunOptions small;
  small.largestFile = 8192;
  expectRefusal(build("design.json", "a.h5"), folder_.path(), "the disk full", small);
}

TEST_F(AtlasCommand, BuildsFromAMeshAndForTumours) {
  const Ran meshed =
      falciform({"mesh", "--preop", at("liver.vtp"), "--edge-length", "24", "--out", at("m.vtu")});
  ASSERT_EQ(meshed.exitCode, 0) << meshed.err;
  ASSERT_EQ(falciform(build("thesis-gravity", "one.h5")).exitCode, 0);
  const Ran ran = falciform({"atlas", "build", "thesis-gravity", "--mesh", at("m.vtu"), "--preop",
                             at("liver.vtp"), "--out", at("two.h5")});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  expectSameBits("one.h5", "two.h5");
}

}  // namespace
}  // namespace falciform::test
