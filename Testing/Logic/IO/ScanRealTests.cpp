#include <gmock/gmock.h>

#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/SurfaceDistances.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Testing/Support/RealData.h"
#include "Testing/Support/TemporaryFolder.h"

// Scans of real scanners: a depth camera above a silicone liver, a laser scanner before a face.

namespace falciform {
namespace {

using namespace test;

TEST(RealScans, TheFaceIsReadWithItsPhotograph) {
  FALCIFORM_NEEDS_DATA("scans/fran_cut.vtk");
  const Loaded<Surface> face = readSurface(realData() / "scans/fran_cut.vtk");
  EXPECT_THAT(face.warnings, testing::Contains(testing::HasSubstr("metres")));
  EXPECT_EQ(face.value.size(), 2205);
  ASSERT_TRUE(face.value.texture);
  EXPECT_EQ(face.value.texture->width, 256);
  // Skin in bluish light.
  const Eigen::RowVector3d mean = face.value.colours.cast<double>().colwise().mean();
  EXPECT_GT(mean[0], mean[1] + 10);
}

TEST(RealScans, ATexturedModelKeepsItsPointsAndTakesItsColours) {
  FALCIFORM_NEEDS_DATA("models/sofa/liver-smoothUV.obj");
  // Its material names no image: the one that belongs to it counts when it is called like the model.
  const TemporaryFolder folder;
  std::filesystem::create_symlink(realData() / "models/sofa/liver-smoothUV.obj", folder / "liver.obj");
  std::filesystem::create_symlink(realData() / "models/sofa/liver-texture-square.png", folder / "liver.png");
  const Surface liver = readSurface(folder / "liver.obj").value;
  ASSERT_TRUE(liver.texture);
  EXPECT_EQ(liver.texture->width, 264);
  EXPECT_EQ(liver.colours.rows(), liver.size());
}

class PressedFrames : public testing::TestWithParam<int> {};

TEST_P(PressedFrames, LieOnTheSurfaceTheyShow) {
  FALCIFORM_NEEDS_DATA("press/rgbd_0.rgbd");
  const auto folder = realData() / "press";
  const int k = GetParam();
  const Surface frame = readSurface(folder / ("rgbd_" + std::to_string(k) + ".rgbd")).value;
  EXPECT_EQ(frame.frame, "tracker");
  EXPECT_GT(frame.size(), 10'000);
  EXPECT_GT(frame.triangles.rows(), frame.size());
  const int state = 4 * k;
  const Surface truth = readSurface(folder / ("surface_" + std::to_string(state) + ".stl")).value;
  // As tracked: the camera's own error and the tracker's. The group that made them calls 2 to 4 mm normal.
  const VectorXd tracked = distancesTo(truth, frame.points);
  EXPECT_LT(tracked.mean(), 5);  // mm
}

INSTANTIATE_TEST_SUITE_P(States, PressedFrames, testing::Values(0, 25, 50));

TEST(RealScans, TheDepthFrameOfTheLiverAtRestRegistersToItsSurface) {
  FALCIFORM_NEEDS_DATA("press/rgbd_0.rgbd");
  const auto folder = realData() / "press";
  const Surface frame = readSurface(folder / "rgbd_0.rgbd").value;
  const Surface truth = readSurface(folder / "surface_0.stl").value;
  const RegistrationResult result = registerSurfaces(truth, frame, registrationPreset("default"));
  const Points back = transformed(frame.points, result.scanFromPreop.inverse());
  const VectorXd distances = distancesTo(truth, back);
  // Depths come in whole mm, and the surface has edges of some 6 mm.
  EXPECT_LT(distances.mean(), 1.5);  // mm
}

}  // namespace
}  // namespace falciform
