#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "Logic/IO/OutputFile.h"
#include "Logic/IO/VolumeFiles.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/SmallCase.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;

TEST(Slicer, ReadsProgressFromStandardOutputAndFiguresFromAFile) {
  const TemporaryFolder folder;
  writeLabelMap(folder / "ball.nii.gz", ballMap(), Overwrite::Refuse);
  // As Slicer calls: every field of the form, the indexed argument last.
  const Ran ran =
      falciform({"import", "--slicer-progress", "--processinformationaddress", "0", "--returnparameterfile",
                 (folder / "figures").string(), "--label", "", "--edge-length", "0", "--out",
                 (folder / "liver.vtp").string(), (folder / "ball.nii.gz").string()});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  EXPECT_THAT(ran.out, testing::StartsWith("<filter-progress>"));
  EXPECT_THAT(ran.out, HasSubstr("<filter-progress>1.000</filter-progress>"));
  const std::string figures = readTextFile(folder / "figures");
  const nlohmann::json sidecar = nlohmann::json::parse(readTextFile(folder / "liver.vtp.json"));
  const std::string key = "surface_volume_mm3 = ";
  ASSERT_THAT(figures, HasSubstr(key));
  EXPECT_DOUBLE_EQ(std::stod(figures.substr(figures.find(key) + key.size())),
                   sidecar["figures"]["surface_volume_mm3"].get<double>());
}

TEST(Slicer, AnUntouchedFieldDoesNotOverruleThePreset) {
  const TemporaryFolder folder;
  writeSmallCase(folder.path());
  const Ran ran = falciform({"register", "--slicer-progress", "--preop", (folder / "preop.vtp").string(),
                             "--scan", (folder / "scan.vtp").string(), "--out", (folder / "out").string(),
                             "--preset", "thesis-phantom", "--method", "picp", "--start", "patches",
                             "--weight-base", "1", "--max-iterations", "5"});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  const auto json = nlohmann::json::parse(readTextFile(folder / "out/register.json"));
  EXPECT_EQ(json["settings"]["registration"]["weightBase"], 25.0);  // the preset's
  EXPECT_EQ(json["settings"]["registration"]["maxIterations"], 5);  // was touched
}

TEST(Slicer, WrappersAnswerWithTheirDescriptionWhateverSlicerSetInTheEnvironment) {
  const std::filesystem::path scripts = std::filesystem::path(FALCIFORM_SOURCE_DIR) / "Resources/Slicer";
  int wrappers = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scripts)) {
    const std::string name = entry.path().filename().string();
    if (name.find('.') != std::string::npos) continue;  // Slicer takes names without a dot
    ++wrappers;
    const TemporaryFolder folder;
    const std::string call = "FALCIFORM='" FALCIFORM_EXECUTABLE
                             "' LD_LIBRARY_PATH=/nowhere QT_PLUGIN_PATH=/nowhere '" +
                             entry.path().string() + "' --xml > '" + (folder / "xml").string() + "' 2> '" +
                             (folder / "err").string() + "'";
    EXPECT_EQ(std::system(call.c_str()), 0) << name;
    EXPECT_THAT(readTextFile(folder / "xml"), testing::StartsWith("<?xml")) << name;
    EXPECT_EQ(readTextFile(folder / "err"), "") << name;
  }
  EXPECT_GE(wrappers, 4);
}

}  // namespace
}  // namespace falciform::test
