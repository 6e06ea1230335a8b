#include <gmock/gmock.h>

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

}  // namespace
}  // namespace falciform::test
