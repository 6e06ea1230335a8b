#include <gmock/gmock.h>

#include <fstream>
#include <limits>

#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/SmallCase.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

/// A folder with the small case and a way to register one file against another.
class BadInput : public testing::Test {
 protected:
  BadInput() { writeSmallCase(folder_.path()); }

  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  void expectRegisterRefuses(const std::string& preop, const std::string& scan, const std::string& mention,
                             std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"register", "--preop", at(preop),     "--scan",
                                       at(scan),   "--out",   at("out/deep")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expectRefusal(arguments, folder_.path(), mention);
  }

  TemporaryFolder folder_;
};

TEST_F(BadInput, MissingFileIsNamed) { expectRegisterRefuses("nowhere.vtp", "scan.vtp", "nowhere.vtp"); }

TEST_F(BadInput, TruncatedVtpIsRefusedAtAnyLength) {
  const std::string whole = readTextFile(at("preop.vtp"));
  for (const double share : {0.0, 0.05, 0.5, 0.98}) {
    SCOPED_TRACE(share);
    std::ofstream(at("cut.vtp"), std::ios::binary)
        << whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size())));
    expectRegisterRefuses("cut.vtp", "scan.vtp", "cut.vtp");
  }
}

TEST_F(BadInput, StlOfNansIsRefused) {
  std::ofstream file(at("nan.stl"), std::ios::binary);
  file << std::string(80, ' ');
  const std::uint32_t count = 2;
  file.write(reinterpret_cast<const char*>(&count), 4);
  const std::vector<float> facet(12, std::numeric_limits<float>::quiet_NaN());
  for (int i = 0; i < 2; ++i) {
    file.write(reinterpret_cast<const char*>(facet.data()), 48);
    file.write("\0\0", 2);
  }
  file.close();
  expectRegisterRefuses("nan.stl", "scan.vtp", "nan.stl");
}

TEST_F(BadInput, ScanOfTwoPointsIsRefused) {
  std::ofstream(at("two.xyz")) << "0 0 0\n1 2 3\n";
  expectRegisterRefuses("preop.vtp", "two.xyz", "2");
}

TEST_F(BadInput, PatchThatIsNotPaintedIsNamed) {
  expectRegisterRefuses("preop.vtp", "scan.vtp", "7", {"--patches", "7"});
}

TEST_F(BadInput, NonManifoldMeshIsRefused) {
  Surface fan = box({60, 50, 40});  // closed: any edge has two triangles, so a flap on it makes three
  const int flap = static_cast<int>(fan.points.rows());
  fan.points.conservativeResize(flap + 1, 3);
  fan.points.row(flap) << 90, 90, 90;
  fan.triangles.conservativeResize(fan.triangles.rows() + 1, 3);
  fan.triangles.bottomRows<1>() << fan.triangles(0, 0), fan.triangles(0, 1), flap;
  writeSurface(at("fan.vtp"), fan, Overwrite::Refuse);
  expectRegisterRefuses("fan.vtp", "scan.vtp", "manifold");
}

TEST_F(BadInput, LabelThatIsNotThereIsNamed) {
  writeLabelMap(at("ball.nii.gz"), ballMap(), Overwrite::Refuse);
  expectRefusal({"import", at("ball.nii.gz"), "--label", "9", "--out", at("liver.vtp")}, folder_.path(), "9");
}

TEST_F(BadInput, LabelMapInMetresIsRefusedWithARemedy) {
  writeLabelMap(at("metres.nrrd"), ballMap(0.001), Overwrite::Refuse);
  expectRefusal({"import", at("metres.nrrd"), "--label", "3", "--out", at("liver.vtp")}, folder_.path(), "m");
}

TEST_F(BadInput, DamagedLabelMapIsRefused) {
  writeLabelMap(at("ball.nii"), ballMap(), Overwrite::Refuse);
  std::filesystem::resize_file(at("ball.nii"), 4000);
  expectRefusal({"import", at("ball.nii"), "--label", "3", "--out", at("liver.vtp")}, folder_.path(),
                "ball.nii");
}

TEST_F(BadInput, TransformThatIsNotRigidIsRefused) {
  std::ofstream(at("scale.txt")) << "2 0 0 0\n0 2 0 0\n0 0 2 0\n0 0 0 1\n";
  expectRefusal({"distance", "--preop", at("preop.vtp"), "--scan", at("scan.vtp"), "--transform",
                 at("scale.txt"), "--out", at("out")},
                folder_.path(), "scale.txt");
}

TEST_F(BadInput, FolderThatCannotBeWrittenIsRefusedBeforeReading) {
  expectRefusal(
      {"register", "--preop", at("nowhere.vtp"), "--scan", at("scan.vtp"), "--out", at("preop.vtp/out")},
      folder_.path(), "preop.vtp");
  expectRefusal({"import", at("nowhere.nii"), "--out", "/proc/liver.vtp"}, folder_.path(), "/proc");
}

TEST_F(BadInput, CaseWithUnknownSettingIsRefused) {
  std::ofstream(at("case.json"))
      << R"({"name": "x", "preop": "preop.vtp", "scan": "scan.vtp", "settings": {"registration": {"wieght": 1}}})";
  expectRefusal({"run", folder_.path().string(), "--out", at("out")}, folder_.path(), "wieght");
}

TEST_F(BadInput, CaseThatIsNoJsonIsRefused) {
  std::ofstream(at("case.json")) << "{";
  expectRefusal({"run", folder_.path().string(), "--out", at("out")}, folder_.path(), "case.json");
}

}  // namespace
}  // namespace falciform::test
