#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Logic/Segmentation/SurfaceImport.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/SmallCase.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class ImportOutput : public testing::Test {
 protected:
  ImportOutput() { writeLabelMap(folder_ / "ball.nii.gz", ballMap(), Overwrite::Refuse); }
  std::vector<std::string> call(std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"import", (folder_ / "ball.nii.gz").string(), "--label", "3",
                                   "--out",  (folder_ / "liver.vtp").string()};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  nlohmann::json sidecar() const { return nlohmann::json::parse(readTextFile(folder_ / "liver.vtp.json")); }

  TemporaryFolder folder_;
};

TEST_F(ImportOutput, IsTheLibrarysSurface) {
  ASSERT_EQ(falciform(call({"--edge-length", "6"})).exitCode, 0);
  SurfaceImportSettings settings;
  settings.labels = {3};
  settings.edgeLengthMm = 6;
  const Surface expected = importSurface(ballMap(), settings).surface;
  const Surface written = readSurface(folder_ / "liver.vtp").value;
  ASSERT_EQ(written.size(), expected.size());
  // NIfTI stores its matrix in single precision: 1e-7 of 160 mm.
  EXPECT_LT((written.points - expected.points).cwiseAbs().maxCoeff(), 1e-3);
}

TEST_F(ImportOutput, SidecarTellsHowItCameToBe) {
  ASSERT_EQ(falciform(call({"--seed", "5", "--threads", "2"})).exitCode, 0);
  const nlohmann::json json = sidecar();
  EXPECT_EQ(json["program"], "falciform");
  EXPECT_EQ(json["seed"], 5);
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["inputs"][0]["file"], "ball.nii.gz");
  EXPECT_EQ(json["inputs"][0]["sha256"], sha256OfFile(folder_ / "ball.nii.gz"));
  EXPECT_EQ(json["settings"]["import"]["labels"], nlohmann::json({3}));
  EXPECT_TRUE(json["figures"]["closed_manifold"]);
  EXPECT_THAT(json["notice"].get<std::string>(), HasSubstr("not a medical device"));
  // Folders may name a patient.
  EXPECT_THAT(json.dump(), Not(HasSubstr(folder_.path().filename().string())));
}

TEST_F(ImportOutput, ReportIsTheSidecarElsewhere) {
  ASSERT_EQ(falciform(call({"--report", (folder_ / "report.json").string()})).exitCode, 0);
  EXPECT_EQ(nlohmann::json::parse(readTextFile(folder_ / "report.json")), sidecar());
}

TEST_F(ImportOutput, ExistingFilesAreKeptWithoutForce) {
  writeTextFile(folder_ / "liver.vtp", Overwrite::Refuse, "precious");
  expectRefusal(call(), folder_.path(), "--force");
  ASSERT_EQ(falciform(call({"--force"})).exitCode, 0);
  EXPECT_GT(readSurface(folder_ / "liver.vtp").value.size(), 100);
}

TEST_F(ImportOutput, AnExistingSidecarIsKeptToo) {
  writeTextFile(folder_ / "liver.vtp.json", Overwrite::Refuse, "precious");
  expectRefusal(call(), folder_.path(), "liver.vtp.json");
}

TEST_F(ImportOutput, NothingHiddenIsLeft) {
  ASSERT_EQ(falciform(call()).exitCode, 0);
  std::vector<std::string> names;
  for (const auto& [name, bytes] : contentsOf(folder_.path())) names.push_back(name);
  EXPECT_THAT(names, testing::ElementsAre("ball.nii.gz", "liver.vtp", "liver.vtp.json"));
}

TEST_F(ImportOutput, QuietPrintsNothing) {
  const Ran ran = falciform(call({"--quiet"}));
  EXPECT_EQ(ran.exitCode, 0);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.err, "");
}

TEST_F(ImportOutput, NoProgressWhereStderrIsNoTerminal) { EXPECT_EQ(falciform(call()).err, ""); }

TEST_F(ImportOutput, InfoSaysWhatTheFilesAre) {
  EXPECT_THAT(falciform({"info", (folder_ / "ball.nii.gz").string()}).out, HasSubstr("label 3: "));
  ASSERT_EQ(falciform(call()).exitCode, 0);
  EXPECT_THAT(falciform({"info", (folder_ / "liver.vtp").string()}).out, HasSubstr("closed manifold"));
}

}  // namespace
}  // namespace falciform::test
