#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "Logic/Deformation/DistanceMapping.h"
#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/SmallCase.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;

class Register : public testing::Test {
 protected:
  Register() : truth_(writeSmallCase(folder_.path())) {}
  Ran run(const std::string& out, std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"register",     "--preop", at("preop.vtp"), "--scan",
                                   at("scan.vtp"), "--out",   at(out)};
    words.insert(words.end(), more.begin(), more.end());
    return falciform(words);
  }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(readTextFile(at(name))); }

  TemporaryFolder folder_;
  SmallCase truth_;
};

TEST_F(Register, IsTheLibraryCall) {
  ASSERT_EQ(run("out").exitCode, 0);
  const RegistrationResult expected = registerSurfaces(
      readSurface(at("preop.vtp")).value, readSurface(at("scan.vtp")).value, registrationPreset("default"));
  for (const char* name :
       {"out/scan_from_preop.txt", "out/scan_from_preop.json", "out/scan_from_preop.tfm"}) {
    const Matrix4d found = readTransform(at(name)).matrix();
    // Text holds all digits of a double; the .tfm is inverted on the way, which costs some rounding of 300
    // mm.
    EXPECT_LT((found - expected.scanFromPreop.matrix()).cwiseAbs().maxCoeff(), 1e-9) << name;
  }
  EXPECT_DOUBLE_EQ(json("out/register.json")["figures"]["rms_mm"], expected.rmsMm);
}

TEST_F(Register, FindsTheKnownPoseWithoutAnyStart) {
  ASSERT_EQ(run("out").exitCode, 0);
  const Points found = transformed(truth_.preop.points, readTransform(at("out/scan_from_preop.txt")));
  const Points expected = transformed(truth_.preop.points, truth_.scanFromPreop);
  // The scan is an exact, noise-free part of the surface; the stop rule leaves 1e-3 mm of motion.
  EXPECT_LT((found - expected).rowwise().norm().maxCoeff(), 0.1);
  const Points moved = readSurface(at("out/preop_on_scan.vtp")).value.points;
  EXPECT_LT((moved - found).cwiseAbs().maxCoeff(), 1e-3);  // single precision in the file at 300 mm
}

TEST_F(Register, GivesTheSameBitsOnOneThreadAndOnTwo) {
  ASSERT_EQ(run("one", {"--threads", "1"}).exitCode, 0);
  ASSERT_EQ(run("two", {"--threads", "2"}).exitCode, 0);
  for (const char* name : {"scan_from_preop.txt", "scan_from_preop.tfm", "preop_on_scan.vtp"})
    EXPECT_TRUE(readTextFile(folder_ / "one" / name) == readTextFile(folder_ / "two" / name)) << name;
  nlohmann::json one = json("one/register.json")["figures"], two = json("two/register.json")["figures"];
  one.erase("seconds");
  two.erase("seconds");
  EXPECT_EQ(one, two);
}

TEST_F(Register, IcpStartsFromThePoseAsStoredAndSaysSo) {
  ASSERT_EQ(run("out", {"--method", "icp"}).exitCode, 0);
  const nlohmann::json written = json("out/register.json");
  EXPECT_EQ(written["settings"]["registration"]["start"], "given");
  EXPECT_THAT(written["figures"]["start"].get<std::string>(), HasSubstr("identity"));
}

TEST_F(Register, StartsFromATransformFileThatIsGiven) {
  writeTransform(at("near.txt"), truth_.scanFromPreop, "maps pre-op to scan", Overwrite::Refuse);
  ASSERT_EQ(run("out", {"--method", "icp", "--init", at("near.txt")}).exitCode, 0);
  const nlohmann::json figures = json("out/register.json")["figures"];
  EXPECT_LT(figures["rotation_deg"].get<double>(), 0.01);  // it starts at the answer
  EXPECT_LT(figures["rms_mm"].get<double>(), 0.01);
}

TEST_F(Register, PresetsAreTakenAndWhatIsGivenBesideThemWins) {
  ASSERT_EQ(
      run("out", {"--preset", "thesis-clinical", "--weight-base", "7", "--max-iterations", "3"}).exitCode, 0);
  const nlohmann::json used = json("out/register.json")["settings"]["registration"];
  nlohmann::json expected = settingsToJson(registrationPreset("thesis-clinical"));
  expected["weightBase"] = 7.0;
  expected["maxIterations"] = 3;
  EXPECT_EQ(used, expected);
}

TEST_F(Register, MeasuresTargetErrorWhereThereIsTruth) {
  Landmarks targets, places;
  for (int i = 0; i < 5; ++i) {
    const Vector3d target = Vector3d(10.0 * i, 20.0 - 7 * i, 5.0 * i * i);
    targets.points.push_back({"t" + std::to_string(i), target});
    places.points.push_back({"t" + std::to_string(i), truth_.scanFromPreop * target + Vector3d(0, 0, 2)});
  }
  places.frame = "scanner";
  writeLandmarks(at("targets.mrk.json"), targets, Overwrite::Refuse);
  writeLandmarks(at("places.mrk.json"), places, Overwrite::Refuse);
  ASSERT_EQ(
      run("out", {"--targets", at("targets.mrk.json"), "--truth-targets", at("places.mrk.json")}).exitCode,
      0);
  const nlohmann::json error = json("out/register.json")["figures"]["target_error"];
  // The truth is shifted by 2 mm, which the scan does not know; the registration is within 0.1 mm.
  EXPECT_NEAR(error["mean_mm"].get<double>(), 2.0, 0.1);
  EXPECT_NEAR(error["optimal_rigid_mean_mm"].get<double>(), 0.0, 1e-6);
}

TEST_F(Register, LandmarkStartNeedsLandmarks) {
  expectRefusal({"register", "--preop", at("preop.vtp"), "--scan", at("scan.vtp"), "--out", at("out"),
                 "--init", "landmarks"},
                folder_.path(), "landmarks");
}

TEST_F(Register, SecondRunIsRefusedWithoutForceAndReplacesWithIt) {
  ASSERT_EQ(run("out").exitCode, 0);
  expectRefusal({"register", "--preop", at("preop.vtp"), "--scan", at("scan.vtp"), "--out", at("out")},
                folder_.path(), "--force");
  EXPECT_EQ(run("out", {"--force"}).exitCode, 0);
}

TEST_F(Register, DistanceOfItsResultIsTheLibrarysMap) {
  ASSERT_EQ(run("out").exitCode, 0);
  ASSERT_EQ(falciform({"distance", "--preop", at("preop.vtp"), "--scan", at("scan.vtp"), "--transform",
                       at("out/scan_from_preop.tfm"), "--out", at("map")})
                .exitCode,
            0);
  const DistanceMap expected =
      mapDistances(readSurface(at("preop.vtp")).value, readSurface(at("scan.vtp")).value,
                   readTransform(at("out/scan_from_preop.tfm")));
  EXPECT_DOUBLE_EQ(json("map/distance.json")["figures"]["coverage"], expected.coverage);
  const VectorXd written = readSurface(at("map/preop_distance.vtp")).value.arrays.at(kSignedDistance);
  const VectorXd& wanted = expected.preop.arrays.at(kSignedDistance);
  ASSERT_EQ(written.size(), wanted.size());
  for (Index i = 0; i < wanted.size(); ++i) {
    ASSERT_EQ(std::isnan(written[i]), std::isnan(wanted[i])) << i;
    if (!std::isnan(wanted[i])) {
      ASSERT_NEAR(written[i], wanted[i], 1e-5);  // at most single precision in the file
    }
  }
}

TEST_F(Register, PatchesAreCarriedToAnUnpaintedCopy) {
  Surface bare = truth_.preop;
  bare.patch.clear();
  writeSurface(at("bare.vtp"), bare, Overwrite::Refuse);
  ASSERT_EQ(falciform({"patches", "--from", at("preop.vtp"), "--to", at("bare.vtp"), "--radius", "0.05",
                       "--out", at("painted.vtp")})
                .exitCode,
            0);
  EXPECT_EQ(readSurface(at("painted.vtp")).value.patch, truth_.preop.patch);
  const Ran told = falciform({"patches", at("painted.vtp")});
  EXPECT_THAT(told.out, HasSubstr("falciform"));
  EXPECT_THAT(told.out, HasSubstr("inferior ridge"));
}

}  // namespace
}  // namespace falciform::test
