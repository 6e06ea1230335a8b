#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "Logic/Core/Draws.h"
#include "Logic/Geometry/Curvature.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/Program.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr double kRadiusMm = 40, kNoiseMm = 0.4;

Surface noisySphere() {
  Surface surface = sphere(kRadiusMm, 5);
  Draws draws(3);
  for (Index i = 0; i < surface.size(); ++i)
    surface.points.row(i) *= 1 + kNoiseMm * draws.normal() / kRadiusMm;
  surface.patch.assign(static_cast<std::size_t>(surface.size()), patch::kNone);
  for (Index i = 0; i < surface.size(); ++i)
    if (surface.points(i, 0) > 0) surface.patch[static_cast<std::size_t>(i)] = patch::kInferiorRidge;
  return surface;
}

class SmoothCommand : public testing::Test {
 protected:
  SmoothCommand() { writeSurface(at("sphere.vtp"), noisySphere(), Overwrite::Refuse); }
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }
  TemporaryFolder folder_;
};

TEST_F(SmoothCommand, WritesACleanSurfaceWithItsCurvatureAndSaysTheNoise) {
  const Ran ran = falciform({"smooth", at("sphere.vtp"), "--out", at("clean.vtp"), "--picture", at("p.png")});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  const Surface clean = readSurface(at("clean.vtp")).value;
  EXPECT_NEAR(signedVolume(clean) / (4.0 / 3 * std::numbers::pi * std::pow(kRadiusMm, 3)), 1, 0.005);
  const VectorXd& curvature = clean.arrays.at(kMeanCurvature);
  EXPECT_NEAR(curvature.mean(), 1 / kRadiusMm, 0.01 / kRadiusMm);
  EXPECT_LT((clean.points.rowwise().norm().array() - kRadiusMm).abs().maxCoeff(), kNoiseMm);
  for (Index i = 0; i < clean.size(); ++i) {
    if (std::abs(clean.points(i, 0)) < 4) continue;  // two edges from the border
    const int expected = clean.points(i, 0) > 0 ? patch::kInferiorRidge : patch::kNone;
    ASSERT_EQ(clean.patchAt(static_cast<int>(i)), expected);
  }
  const json sidecar = json::parse(readTextFile(at("clean.vtp.json")));
  EXPECT_NEAR(sidecar["figures"]["noise_mm"].get<double>(), kNoiseMm, 0.1 * kNoiseMm);
  EXPECT_TRUE(std::filesystem::exists(at("p.png")));
}

TEST_F(SmoothCommand, AnEdgeLengthIsKept) {
  ASSERT_EQ(falciform({"smooth", at("sphere.vtp"), "--out", at("coarse.vtp"), "--edge-length", "4"}).exitCode,
            0);
  EXPECT_NEAR(meanEdgeLength(readSurface(at("coarse.vtp")).value), 4, 0.4);
}

TEST_F(SmoothCommand, TooFewPointsAndImpossibleEdgesAreRefusedWithNothingWritten) {
  Surface few;
  few.points = Points::Random(5, 3);
  few.normals = Points::Zero(5, 3);
  few.normals.col(2).setOnes();
  writeSurface(at("few.vtp"), few, Overwrite::Refuse);
  expectRefusal({"smooth", at("few.vtp"), "--out", at("x.vtp")}, folder_.path(), "at least 30");
  expectRefusal({"smooth", at("sphere.vtp"), "--out", at("x.vtp"), "--edge-length", "0.001"}, folder_.path(),
                "choose at least");
}

}  // namespace
}  // namespace falciform::test
