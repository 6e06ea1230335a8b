// `falciform update --atlas --method`: what was solved before the operation is used, and what does not suit
// is refused in words.

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/Program.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;

/// The built-in liver, coarse, packed by 15 mm; what several tests need is made once.
class UpdateMethodCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared_ = std::make_unique<TemporaryFolder>();
    done({"synthesise", "--out", at("case"), "--packing", "15", "--packed-edge-length", "13", "--edge-length",
          "4", "--voxel", "4"});
    done({"mesh", "--preop", at("case/preop_painted.vtp"), "--edge-length", "16", "--out", at("m.vtu")});
    std::ofstream(at("packing.json")) << R"({"preset": "thesis-packing",
        "packing": {"places": 8, "stepMm": 5, "maxPushMm": 20}})";
    for (const char* design : {"surface-loads", "packing.json"})
      done({"atlas", "build", std::string(design) == "packing.json" ? at(design) : design, "--preop",
            at("case/preop_painted.vtp"), "--mesh", at("m.vtu"), "--out", at(std::string(design) + ".h5")});
  }
  static void TearDownTestSuite() { shared_.reset(); }
  static void done(const std::vector<std::string>& words) {
    const Ran ran = falciform(words);
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
  }
  static std::string at(const std::string& name) { return (*shared_ / name).string(); }
  std::vector<std::string> words(const std::vector<std::string>& more) const {
    std::vector<std::string> all{"update",
                                 "--preop",
                                 at("case/preop_painted.vtp"),
                                 "--scan",
                                 at("case/scan.vtp"),
                                 "--targets",
                                 at("case/targets.mrk.json"),
                                 "--truth-targets",
                                 at("case/truth_targets.mrk.json"),
                                 "--out",
                                 (folder_ / "out").string()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  nlohmann::json sidecar(const std::vector<std::string>& more) const {
    std::vector<std::string> all = words(more);
    all.push_back("--force");
    const Ran ran = falciform(all);
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    std::ifstream stream(folder_ / "out/update.json");
    return nlohmann::json::parse(stream);
  }

  static inline std::unique_ptr<TemporaryFolder> shared_;
  TemporaryFolder folder_;
};

TEST_F(UpdateMethodCommand, LoadsSolvedBeforeGiveTheSameUpdate) {
  const nlohmann::json fresh = sidecar({"--mesh", at("m.vtu")});
  const nlohmann::json stored = sidecar({"--atlas", at("surface-loads.h5")});
  EXPECT_EQ(stored.at("settings").at("method"), "model");
  // The same bits went into both, the mesh's file keeping more digits than matter.
  EXPECT_NEAR(stored.at("figures").at("target_error_mean_mm").get<double>(),
              fresh.at("figures").at("target_error_mean_mm").get<double>(), 1e-3);
  bool named = false;
  for (const nlohmann::json& input : stored.at("inputs"))
    named = named || input.at("file") == "surface-loads.h5";
  EXPECT_TRUE(named);
}

TEST_F(UpdateMethodCommand, EveryMethodMovesTheLiver) {
  for (const char* method : {"icat", "icat-star", "constrained", "pca", "libr", "incremental"}) {
    const std::string atlas = std::string(method) == "libr" ? "surface-loads.h5" : "packing.json.h5";
    const nlohmann::json told = sidecar({"--method", method, "--atlas", at(atlas)});
    EXPECT_EQ(told.at("settings").at("method"), method);
    const nlohmann::json figures = told.at("figures");
    EXPECT_EQ(figures.count("expected_error_mean_mm"), 0U) << method;
    EXPECT_GT(figures.at("largest_displacement_mm").get<double>(), 1) << method;
    // Not farther off than a liver that was never registered: these are baselines, of the literature's merit.
    EXPECT_LT(figures.at("target_error").at("mean_mm").get<double>(), 20) << method;
  }
}

TEST_F(UpdateMethodCommand, AnAtlasThatDoesNotSuitIsRefusedInOneLine) {
  const auto& folder = folder_.path();
  expectRefusal(words({"--method", "icat"}), folder, "no --atlas is given");
  expectRefusal(words({"--atlas", at("packing.json.h5")}), folder, "works with surface loads");
  expectRefusal(words({"--method", "pca", "--atlas", at("surface-loads.h5")}), folder,
                "needs an atlas of deformations");
  expectRefusal(words({"--atlas", at("surface-loads.h5"), "--mesh", at("m.vtu")}), folder, "leave one out");
  expectRefusal(words({"--atlas", at("m.vtu")}), folder, "no falciform atlas");
  expectRefusal(words({"--method", "best"}), folder, "icat-star");
  Surface elsewhere = readSurface(at("case/preop_painted.vtp")).value;
  elsewhere.points.col(0).array() += 200;  // mm: another liver's place
  writeSurface(folder_ / "elsewhere.vtp", elsewhere, Overwrite::Refuse);
  std::vector<std::string> other = words({"--atlas", at("surface-loads.h5")});
  other[2] = (folder_ / "elsewhere.vtp").string();
  expectRefusal(other, folder, "another liver");
}

TEST_F(UpdateMethodCommand, InfoTellsOfSurfaceLoads) {
  const Ran told = falciform({"atlas", "info", at("surface-loads.h5")});
  ASSERT_EQ(told.exitCode, 0) << told.err;
  EXPECT_THAT(told.out, HasSubstr("360 loads at 120 places"));
  expectRefusal({"atlas", "info", at("surface-loads.h5"), "--members"}, folder_.path(), "has no members");
  expectRefusal({"atlas", "build", "surface-loads", "--mesh", at("m.vtu"), "--out",
                 (folder_ / "a.h5").string(), "--shard", "0/2"},
                folder_.path(), "one process");
}

}  // namespace
}  // namespace falciform::test
