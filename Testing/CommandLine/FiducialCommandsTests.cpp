#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "Logic/Acquisition/Phantom.h"
#include "Logic/Acquisition/PhantomCt.h"
#include "Logic/Core/Draws.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Logic/Registration/PointRegistration.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/Program.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;

constexpr double kRadius = 9;

/// Two Teflon balls in air, with partial volume by their depth.
Image ballsCt(const std::vector<Vector3d>& centres) {
  Image ct;
  ct.size = {60, 50, 45};
  ct.worldFromIndex.topLeftCorner<3, 3>() *= 1.5;
  ct.worldFromIndex.topRightCorner<3, 1>() << -30, 12, 200;
  for (int k = 0; k < ct.size.z(); ++k)
    for (int j = 0; j < ct.size.y(); ++j)
      for (int i = 0; i < ct.size.x(); ++i) {
        double share = 0;
        for (const Vector3d& centre : centres)
          share +=
              std::clamp(0.5 + (kRadius - (ct.world(Vector3d(i, j, k)) - centre).norm()) / 1.5, 0.0, 1.0);
        ct.voxels.push_back(
            static_cast<float>(std::round(phantom::kAirHu + share * (phantom::kTeflonHu - phantom::kAirHu))));
      }
  return ct;
}

class FiducialCommands : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  TemporaryFolder folder_;
  std::vector<Vector3d> centres_{{-5.3, 40.2, 230.1}, {32.7, 61.9, 236.4}};
};

TEST_F(FiducialCommands, MarkersOfACtAreFoundByClickOrAllAtOnce) {
  writeImage(at("ct.nrrd"), ballsCt(centres_), Overwrite::Refuse);
  writeLandmarks(at("truth.mrk.json"), {{{"a", centres_[0]}, {"b", centres_[1]}}, "LPS"}, Overwrite::Refuse);
  const Ran clicked = falciform({"locate", at("ct.nrrd"), "--seed", "-4,42,231; 33,60,238", "--threshold",
                                 "-25", "--out", at("c.mrk.json"), "--truth", at("truth.mrk.json")});
  ASSERT_EQ(clicked.exitCode, 0) << clicked.err;
  const Ran all = falciform({"locate", at("ct.nrrd"), "--all", "--threshold", "-25", "--smallest", "10",
                             "--largest", "30", "--out", at("a.mrk.json"), "--truth", at("truth.mrk.json")});
  ASSERT_EQ(all.exitCode, 0) << all.err;
  for (const char* name : {"c.mrk.json", "a.mrk.json"}) {
    EXPECT_EQ(readLandmarks(at(name)).value.points.size(), 2u);
    const nlohmann::json figures = readJsonFile(at(std::string(name) + ".json"))["figures"];
    EXPECT_LT(figures["error_largest_mm"].get<double>(), 0.05);  // mm; a voxel is 1.5 mm
    EXPECT_EQ(figures["found"].get<int>(), 2);
    EXPECT_NEAR(figures["markers"][0]["volume_mm3"].get<double>(), 3054, 60);  // mm3 of a ball of 9 mm
  }
  EXPECT_THAT(all.out, HasSubstr("against the truth"));
}

TEST_F(FiducialCommands, SpheresOfAScanAreFittedWithTheirRadiusAndNames) {
  Draws draws(5);
  falciform::Points scan(800, 3);  // the half of each sphere that faces +z
  for (Index i = 0; i < scan.rows(); ++i) {
    Vector3d out = draws.direction();
    out.z() = std::abs(out.z());
    scan.row(i) =
        (centres_[static_cast<std::size_t>(i % 2)] + (kRadius + 0.3 * draws.normal()) * out).transpose();
  }
  Surface cloud;
  cloud.points = scan;
  cloud.frame = "scanner";
  writeSurface(at("scan.vtp"), cloud, Overwrite::Refuse);
  writeLandmarks(at("clicks.mrk.json"),
                 {{{"left", centres_[0] + Vector3d(2, -1, 3)}, {"right", centres_[1]}}, "scanner"},
                 Overwrite::Refuse);
  const Ran ran = falciform({"locate", at("scan.vtp"), "--seeds", at("clicks.mrk.json"), "--radius", "9",
                             "--out", at("found.mrk.json")});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  const Landmarks found = readLandmarks(at("found.mrk.json")).value;
  ASSERT_EQ(found.points.size(), 2u);
  EXPECT_EQ(found.points[0].name, "left");
  for (std::size_t s = 0; s < 2;
       ++s)  // 400 points of 0.3 mm on a half: 0.3 / sqrt(400) x 3 axes, times three
    EXPECT_LT((found.points[s].position - centres_[s]).norm(), 0.15);
}

TEST_F(FiducialCommands, PointRegistrationTellsFreFleAndTheErrorAtTargets) {
  Isometry3d truth = Isometry3d::Identity();
  truth.linear() = Eigen::AngleAxisd(1.1, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  truth.translation() << 120, -40, 300;
  Draws draws(7);
  Landmarks from, to, targets, there;
  for (int n = 0; n < 6; ++n) {
    const Vector3d p = 80 * draws.normal3();
    from.points.push_back({"f" + std::to_string(n), p});
    to.points.push_back({"f" + std::to_string(n), truth * p + 0.4 * draws.normal3()});
  }
  to.frame = "tracker";
  for (int n = 0; n < 4; ++n) {
    targets.points.push_back({"t" + std::to_string(n), 30 * draws.normal3()});
    there.points.push_back({"t" + std::to_string(n), truth * targets.points.back().position});
  }
  there.frame = "tracker";
  for (const auto& [name, list] : {std::pair("from.mrk.json", &from),
                                   {"to.mrk.json", &to},
                                   {"targets.mrk.json", &targets},
                                   {"there.mrk.json", &there}})
    writeLandmarks(at(name), *list, Overwrite::Refuse);
  const Ran ran =
      falciform({"fiducials", "--from", at("from.mrk.json"), "--to", at("to.mrk.json"), "--targets",
                 at("targets.mrk.json"), "--truth-targets", at("there.mrk.json"), "--out", at("t.tfm")});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  const PointRegistrationResult expected =
      registerPoints(readLandmarks(at("from.mrk.json")).value, readLandmarks(at("to.mrk.json")).value);
  const nlohmann::json figures = readJsonFile(at("t.tfm.json"))["figures"];
  EXPECT_NEAR(figures["fre_mm"].get<double>(), expected.freMm, 1e-9);
  EXPECT_EQ(figures["fiducials"].size(), 6u);
  EXPECT_LT((readTransform(at("t.tfm")).matrix() - expected.targetFromSource.matrix()).norm(), 1e-9);
  double sum = 0;
  for (const auto& row : figures["targets"]) {
    sum += std::pow(row["tre_mm"].get<double>(), 2);
    EXPECT_GT(row["expected_tre_mm"].get<double>(), 0);
  }
  EXPECT_NEAR(figures["tre_rms_mm"].get<double>(), std::sqrt(sum / 4), 1e-9);
  EXPECT_THAT(ran.out, HasSubstr("FRE"));
}

TEST_F(FiducialCommands, MistakesAreOneLineAndWriteNothing) {
  writeImage(at("ct.nrrd"), ballsCt(centres_), Overwrite::Refuse);
  Surface cloud;
  cloud.points = falciform::Points::Random(50, 3);
  writeSurface(at("scan.vtp"), cloud, Overwrite::Refuse);
  writeLandmarks(at("two.mrk.json"), {{{"a", {0, 0, 0}}, {"b", {9, 0, 0}}}, "LPS"}, Overwrite::Refuse);
  const auto& folder = folder_.path();
  const std::string out = at("o.mrk.json");
  expectRefusal({"locate", at("ct.nrrd"), "--threshold", "0", "--out", out}, folder, "--all");
  expectRefusal({"locate", at("ct.nrrd"), "--seed", "0,0,0", "--out", out}, folder, "--threshold is missing");
  expectRefusal({"locate", at("ct.nrrd"), "--seed", "-4,42,231", "--all", "--threshold", "0", "--out", out},
                folder, "leave out --seed");
  expectRefusal({"locate", at("ct.nrrd"), "--seed", "25,20,210", "--threshold", "0", "--out", out}, folder,
                "below the threshold");
  expectRefusal({"locate", at("ct.nrrd"), "--all", "--threshold", "3000", "--out", out}, folder,
                "at least 3000");
  expectRefusal({"locate", at("scan.vtp"), "--seed", "0,0,0", "--out", out}, folder, "--radius is missing");
  expectRefusal({"locate", at("scan.vtp"), "--all", "--radius", "5", "--out", out}, folder, "for a CT");
  expectRefusal({"locate", at("scan.vtp"), "--seed", "500,0,0", "--radius", "5", "--out", out}, folder,
                "click 1");
  expectRefusal({"fiducials", "--from", at("two.mrk.json"), "--to", at("two.mrk.json"), "--out", at("t.tfm")},
                folder, "3");
}

}  // namespace
}  // namespace falciform::test
