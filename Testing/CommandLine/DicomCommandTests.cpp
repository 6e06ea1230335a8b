#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "Logic/IO/OutputFile.h"
#include "Testing/CommandLine/Program.h"
#include "Testing/Logic/IO/DicomBytes.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int kSide = 40;
constexpr double kVoxelMm = 4;

/// A mask series of a ball, in files whose names and folder name the patient.
void writeBall(const std::filesystem::path& folder, const std::string& series, double radiusMm) {
  std::filesystem::create_directories(folder);
  for (int k = 0; k < kSide; ++k) {
    SlicePlan plan;
    plan.series = series;
    plan.instance = series + "." + std::to_string(k);
    plan.intercept = "0";
    plan.columns = plan.rows = kSide;
    plan.spacing = "4\\4";
    plan.position = "0\\0\\" + std::to_string(kVoxelMm * k);
    for (int j = 0; j < kSide; ++j)
      for (int i = 0; i < kSide; ++i)
        plan.values.push_back(kVoxelMm * std::hypot(i - 19.5, j - 19.5, k - 19.5) < radiusMm ? 1 : 0);
    std::ofstream(folder / ("MARKER_" + std::to_string((k * 7) % kSide)), std::ios::binary)
        << dicomSlice(plan);
  }
}

class DicomCommands : public testing::Test {
 protected:
  DicomCommands() {
    writeBall(masks / "liver", "1.5", 60);
    writeBall(masks / "tumour", "1.6", 20);
  }
  std::string path(const std::string& name) const { return (folder / name).string(); }

  TemporaryFolder folder;
  std::filesystem::path masks = folder / "SURNAME_MARKER";
};

TEST_F(DicomCommands, InfoListsTheSeriesAndNamesNobody) {
  std::ofstream(masks / "readme.txt") << "other";
  const Ran ran = falciform({"info", masks.string(), "--report", path("info.json")});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  EXPECT_THAT(ran.out,
              HasSubstr("1: CT 'liver', 40 x 40 x 40 voxels of 4.000 x 4.000 x 4.000 mm, 40 files ["));
  EXPECT_THAT(ran.out, HasSubstr("2: CT 'tumour'"));
  EXPECT_THAT(ran.out, HasSubstr("1 files of other kinds passed over"));
  const std::string report = readTextFile(folder / "info.json");
  EXPECT_FALSE(tellsIdentity(ran.out + ran.err + report)) << ran.out << ran.err << report;
  EXPECT_EQ(nlohmann::json::parse(report)["figures"]["series"].size(), 2u);
}

TEST_F(DicomCommands, MasksAreImportedTogetherOrOneOfThem) {
  const Ran both = falciform({"import", masks.string(), "--label", "1", "--out", path("both.vtp")});
  ASSERT_EQ(both.exitCode, 0) << both.err;
  EXPECT_THAT(both.out, HasSubstr("label 1: liver"));
  EXPECT_THAT(both.out, HasSubstr("label 2: tumour"));
  const std::string sidecar = readTextFile(folder / "both.vtp.json");
  EXPECT_FALSE(tellsIdentity(both.out.substr(both.out.find("label")) + both.err + sidecar)) << sidecar;
  const auto json = nlohmann::json::parse(sidecar);
  EXPECT_EQ(json["figures"]["label_names"]["2"], "tumour");
  ASSERT_EQ(json["inputs"].size(), 2u);
  EXPECT_THAT(json["inputs"][0]["file"].get<std::string>(), testing::StartsWith("DICOM series "));
  EXPECT_EQ(json["inputs"][0]["sha256"].get<std::string>().size(), 64u);

  const Ran one = falciform({"import", masks.string(), "--series", "2", "--out", path("one.vtp")});
  ASSERT_EQ(one.exitCode, 0) << one.err;
  const auto figures = nlohmann::json::parse(readTextFile(folder / "one.vtp.json"))["figures"];
  const double ball = 4.0 / 3 * M_PI * std::pow(20.0, 3);
  EXPECT_NEAR(figures["voxel_volume_mm3"].get<double>(), ball, 0.1 * ball) << "4 mm voxels on a 20 mm ball";
}

TEST_F(DicomCommands, WrongSeriesIsRefusedWithTheChoices) {
  const Ran ran = falciform({"import", masks.string(), "--series", "5", "--out", path("x.vtp")});
  EXPECT_EQ(ran.exitCode, 2);
  EXPECT_EQ(lineCount(ran.err), 1) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("2: CT 'tumour'"));
  EXPECT_FALSE(tellsIdentity(ran.err)) << ran.err;
}

}  // namespace
}  // namespace falciform::test
