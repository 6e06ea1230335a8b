#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "Logic/IO/OutputFile.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/Support/RealData.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

TEST(RealCase, BrokenVtkFileIsRefused) {
  FALCIFORM_NEEDS_DATA("models/sofa/liver_for_test_broken.vtk");
  const TemporaryFolder folder;
  expectRefusal({"info", (realData() / "models/sofa/liver_for_test_broken.vtk").string()}, folder.path(),
                "liver_for_test_broken.vtk");
}

TEST(RealCase, LiverIsImportedFromItsSegments) {
  FALCIFORM_NEEDS_DATA("ircad17/couinaud.nii.gz");
  const TemporaryFolder folder;
  const Ran ran =
      falciform({"import", (realData() / "ircad17/couinaud.nii.gz").string(), "--label", "1,2,3,4,5,6,7,8",
                 "--edge-length", "3", "--out", (folder / "liver.vtp").string()});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  const auto figures = nlohmann::json::parse(readTextFile(folder / "liver.vtp.json"))["figures"];
  EXPECT_TRUE(figures["closed_manifold"]);
  EXPECT_NEAR(figures["surface_volume_mm3"].get<double>() / figures["voxel_volume_mm3"].get<double>(), 1.0,
              0.01);
}

TEST(RealCase, ScanIsRegisteredFromThePoseAsStored) {
  FALCIFORM_NEEDS_DATA("update/ircad10_both/scan.vtp");
  const TemporaryFolder folder;
  const std::filesystem::path data = realData() / "update/ircad10_both";
  const Ran ran = falciform({"register", "--preop", (data / "preop.vtp").string(), "--scan",
                             (data / "scan.vtp").string(), "--out", (folder / "out").string()});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  for (const char* name : {"scan_from_preop.tfm", "scan_from_preop.txt", "scan_from_preop.json",
                           "preop_on_scan.vtp", "register.json"})
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / name)) << name;
}

#ifdef FALCIFORM_WITH_UPDATE
/// The whole chain on a real liver, from its segments and a scan of it packed: under a minute.
TEST(RealCase, OneCommandLeadsFromLabelMapAndScanToTheBentLabelMapAndReport) {
  FALCIFORM_NEEDS_DATA("ircad17/couinaud.nii.gz");
  FALCIFORM_NEEDS_DATA("update/ircad17_left/scan.vtp");
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "case");
  const auto link = [&](const char* file, const char* name) {
    std::filesystem::create_symlink(std::filesystem::absolute(realData() / file), folder / "case" / name);
  };
  link("ircad17/couinaud.nii.gz", "labels.nii.gz");
  link("update/ircad17_left/scan.vtp", "scan.vtp");
  link("update/ircad17_left/preop.vtp", "painted.vtp");
  const auto truth = nlohmann::json::parse(readTextFile(realData() / "update/ircad17_left/truth.json"));
  for (const auto& [key, name] :
       {std::pair("targets_preop_mm", "targets"), {"targets_scanner_mm", "truth"}}) {
    nlohmann::json points = nlohmann::json::array();
    for (const nlohmann::json& place : truth.at(key))
      points.push_back({{"label", std::to_string(points.size() + 1)}, {"position", place}});
    const nlohmann::json markups{
        {"markups", {{{"type", "Fiducial"}, {"coordinateSystem", "LPS"}, {"controlPoints", points}}}}};
    std::ofstream(folder / "case" / (std::string(name) + ".mrk.json")) << markups.dump();
  }
  std::ofstream(folder / "case/case.json") << nlohmann::json{
      {"name", "Real liver"},
      {"labelMap", "labels.nii.gz"},
      {"preopPatches", "painted.vtp"},
      {"scan", "scan.vtp"},
      {"targets", "targets.mrk.json"},
      {"truthTargets", "truth.mrk.json"},
      {"settings",
       {{"import", {{"edgeLengthMm", 3}}}}}}.dump();
  const Ran ran = falciform(
      {"run", (folder / "case").string(), "--out", (folder / "out").string(), "--grid-spacing", "6"});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  const auto figures = nlohmann::json::parse(readTextFile(folder / "out/run.json")).at("figures");
  const nlohmann::json& error = figures.at("update").at("target_error");
  // The aim of the update on cases whose best rigid error is above 3 mm, as here (3.55 mm).
  EXPECT_LT(error.at("mean_mm").get<double>(), 0.7 * error.at("optimal_rigid_mean_mm").get<double>());
  EXPECT_LT(error.at("mean_mm").get<double>(), error.at("start_mean_mm").get<double>());
  for (const char* name : {"labels_updated.nii.gz", "displacement.nrrd", "updated.vtp"})
    EXPECT_TRUE(std::filesystem::exists(folder / "out/update" / name)) << name;
  EXPECT_TRUE(std::filesystem::exists(folder / "out/report.html"));
}
#endif

}  // namespace
}  // namespace falciform::test
