#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/SmallCase.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;

/// `falciform register --method` with the methods of the literature, started at the answer.
class OtherMethod : public testing::Test {
 protected:
  OtherMethod() : case_(writeSmallCase(folder_.path())) {
    writeTransform(at("near.txt"), case_.scanFromPreop, "maps pre-op to scan", Overwrite::Refuse);
  }
  [[nodiscard]] std::vector<std::string> words(const std::string& method) const {
    return {"register", "--preop",  at("preop.vtp"), "--scan", at("scan.vtp"), "--out",
            at(method), "--method", method,          "--init", at("near.txt")};
  }
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] nlohmann::json report(const std::string& method) const {
    return nlohmann::json::parse(readTextFile(folder_ / method / "register.json"));
  }
  [[nodiscard]] Points moved(const std::string& method) const {
    return readSurface(at(method) + "/preop_on_scan.vtp").value.points;
  }
  [[nodiscard]] Points movedRigidly(const std::string& method) const {
    return transformed(case_.preop.points, readTransform(at(method) + "/scan_from_preop.txt"));
  }

  TemporaryFolder folder_;
  SmallCase case_;
};

TEST_F(OtherMethod, ARigidOneWritesTheSurfaceMovedRigidly) {
  for (const std::string method : {"dirr", "cpt"}) {
    ASSERT_EQ(falciform(words(method)).exitCode, 0) << method;
    EXPECT_LT((moved(method) - movedRigidly(method)).cwiseAbs().maxCoeff(), 1e-3);  // single precision
    EXPECT_EQ(report(method)["settings"]["registration"]["method"], method);
  }
}

TEST_F(OtherMethod, ANonRigidOneWritesItsWarpAndMeasuresTargetsThroughIt) {
  // The scan as it would be had the body bent: the transform alone cannot carry the surface there.
  Surface bent = case_.scan;
  for (Index i = 0; i < bent.size(); ++i) {
    Vector3d p = case_.scanFromPreop.inverse() * bent.points.row(i).transpose();
    p.z() += 12 * std::exp(-(p - Vector3d(40, 0, 40)).squaredNorm() / (2 * 40 * 40));
    bent.points.row(i) = (case_.scanFromPreop * p).transpose();
  }
  writeSurface(at("scan.vtp"), bent, Overwrite::Replace);
  Landmarks targets, truth;
  for (const int i : {0, 50, 100}) {  // any vertices: truth is where the rigid motion has them
    const Vector3d p = case_.preop.points.row(i).transpose();
    targets.points.push_back({"t" + std::to_string(i), p});
    truth.points.push_back({"t" + std::to_string(i), case_.scanFromPreop * p});
  }
  writeLandmarks(at("targets.mrk.json"), targets, Overwrite::Refuse);
  writeLandmarks(at("truth.mrk.json"), truth, Overwrite::Refuse);
  for (const std::string method : {"tps", "rpm"}) {
    std::vector<std::string> all = words(method);
    all.insert(all.end(), {"--targets", at("targets.mrk.json"), "--truth-targets", at("truth.mrk.json")});
    ASSERT_EQ(falciform(all).exitCode, 0) << method;
    const Points warped = moved(method);
    EXPECT_GT((warped - movedRigidly(method)).rowwise().norm().maxCoeff(), 1) << method;  // mm: it bends
    EXPECT_THAT(report(method)["warnings"].dump(), HasSubstr("not rigid"));
    for (int k = 0; k < 3; ++k) {
      const Vector3d expected = truth.points[static_cast<std::size_t>(k)].position;
      EXPECT_NEAR(
          report(method)["figures"]["target_error"]["targets"][static_cast<std::size_t>(k)]["error_mm"]
              .get<double>(),
          (warped.row(50 * k).transpose() - expected).norm(), 1e-3)  // mm: single precision in the file
          << method << " target " << k;
    }
  }
}

TEST_F(OtherMethod, ColourNeedsColours) {
  expectRefusal(words("colour"), folder_.path(), "has no colours");
  Surface preop = case_.preop, scan = case_.scan;
  preop.colours = Colours::Constant(preop.size(), 3, 120);
  scan.colours = Colours::Constant(scan.size(), 3, 130);
  writeSurface(at("preop.vtp"), preop, Overwrite::Replace);
  writeSurface(at("scan.vtp"), scan, Overwrite::Replace);
  EXPECT_EQ(falciform(words("colour")).exitCode, 0);
}

TEST_F(OtherMethod, HelpAndSlicersFormNameThemAll) {
  const std::string help = falciform({"register", "--help"}).out, xml = falciform({"register", "--xml"}).out;
  for (const std::string method : {"dirr", "cpt", "colour", "tps", "rpm"}) {
    EXPECT_THAT(help, HasSubstr(method));
    EXPECT_THAT(xml, HasSubstr("<element>" + method + "</element>"));
  }
}

}  // namespace
}  // namespace falciform::test
