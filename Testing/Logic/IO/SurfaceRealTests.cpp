#include <gmock/gmock.h>

#include <regex>

#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/RealData.h"

namespace falciform {
namespace {

using namespace test;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// How many points a file holds by its own header, or by counting its lines: without the readers.
Index pointsSaidBy(const fs::path& file) {
  const std::string text = readTextFile(file), extension = file.extension().string();
  if (extension == ".stl") return 987;  // the data's README; STL itself does not say
  if (extension == ".obj" || extension == ".xyz") {
    Index lines = 0;
    for (std::size_t at = 0; at < text.size(); at = std::min(text.find('\n', at), text.size() - 1) + 1)
      lines += extension == ".xyz" || text.compare(at, 2, "v ") == 0;
    return lines;
  }
  std::smatch found;
  const std::regex said("NumberOfPoints=\"(\\d+)\"|\nPOINTS (\\d+)|element vertex (\\d+)");
  const std::string head = text.substr(0, 2000);
  if (!std::regex_search(head, found, said)) return -1;
  return std::stol(found[1].str() + found[2].str() + found[3].str());
}

class RealSurfaces : public testing::TestWithParam<const char*> {};

TEST_P(RealSurfaces, OpenWithThePointsTheySayTheyHave) {
  FALCIFORM_NEEDS_DATA(GetParam());
  int opened = 0;
  for (const auto& entry : fs::recursive_directory_iterator(realData() / GetParam())) {
    const std::string name = entry.path().filename().string(), extension = entry.path().extension().string();
    const auto& known = surfaceExtensions();
    if (std::find(known.begin(), known.end(), extension) == known.end()) continue;
    if (name.starts_with("volume_") || name == "liver_for_test_broken.vtk" || extension == ".rgbd")
      continue;  // tetrahedra; see below; depth frames
    const Loaded<Surface> loaded = readSurface(entry.path());
    EXPECT_EQ(loaded.value.size(), pointsSaidBy(entry.path())) << entry.path();
    if (extension == ".obj" || extension == ".stl" || extension == ".vtk") {
      EXPECT_GT(loaded.value.triangles.rows(), 0) << entry.path();
    }
    ++opened;
  }
  EXPECT_GT(opened, 1);
}

INSTANTIATE_TEST_SUITE_P(Folders, RealSurfaces,
                         testing::Values("surfaces", "update", "press", "insilico", "models", "rigid_pairs"));

TEST(RealSurfaceFiles, TheBrokenLiverIsRefusedInOneClearLine) {
  FALCIFORM_NEEDS_DATA("models/sofa/liver_for_test_broken.vtk");
  const std::string message =
      refusalOf([] { (void)readSurface(realData() / "models/sofa/liver_for_test_broken.vtk"); });
  EXPECT_THAT(message, testing::AllOf(HasSubstr("liver_for_test_broken.vtk"), HasSubstr("a wrong count"),
                                      testing::Not(HasSubstr("\n"))));
}

TEST(RealSurfaceFiles, TetrahedraAreRefusedBySayingSo) {
  FALCIFORM_NEEDS_DATA("press/volume_0.vtk");
  EXPECT_THAT(refusalOf([] { (void)readSurface(realData() / "press/volume_0.vtk"); }),
              HasSubstr("UNSTRUCTURED_GRID"));
}

TEST(RealSurfaceFiles, DeformedLiversCarryPatchesAndFrames) {
  FALCIFORM_NEEDS_DATA("update/ircad5_left");
  const Loaded<Surface> preop = readSurface(realData() / "update/ircad5_left/preop.vtp");
  const Loaded<Surface> scan = readSurface(realData() / "update/ircad5_left/scan.vtp");
  EXPECT_THAT(preop.warnings, testing::IsEmpty());
  EXPECT_EQ(preop.value.size(), 57999);
  EXPECT_EQ(preop.value.triangles.rows(), 116006);
  EXPECT_EQ(preop.value.frame, "LPS");
  EXPECT_THAT(patchLabels(preop.value), testing::ElementsAre(1, 2));
  EXPECT_EQ(scan.value.size(), 20116);
  EXPECT_EQ(scan.value.triangles.rows(), 0);
  EXPECT_NE(scan.value.frame, "LPS");
  EXPECT_THAT(patchLabels(scan.value), testing::ElementsAre(1, 2));
}

TEST(RealSurfaceFiles, PressedSurfacesCorrespondTriangleByTriangle) {
  FALCIFORM_NEEDS_DATA("press/surface_0.stl");
  const Surface rest = readSurface(realData() / "press/surface_0.stl").value;
  const Surface pressed = readSurface(realData() / "press/surface_200.stl").value;
  ASSERT_EQ(rest.triangles, pressed.triangles);  // merged corners keep their order
  const VectorXd moved = (pressed.points - rest.points).rowwise().norm();
  EXPECT_NEAR(moved.mean(), 6.6, 0.2);  // mm: the README's figure for the nodes, rounded
  EXPECT_NEAR(moved.maxCoeff(), 17.5, 0.5);
}

TEST(RealSurfaceFiles, UnitsThatAreNotMillimetresAreWarnedOf) {
  FALCIFORM_NEEDS_DATA("scans/fran_cut.vtk");
  EXPECT_THAT(readSurface(realData() / "scans/fran_cut.vtk").warnings,
              testing::Contains(HasSubstr("looks like metres")));
}

TEST(RealTransformFiles, TheLidarPoseReads) {
  FALCIFORM_NEEDS_DATA("rigid_pairs/lidar/T_target_source.txt");
  EXPECT_NEAR(readTransform(realData() / "rigid_pairs/lidar/T_target_source.txt").translation().x(), 0.488882,
              1e-9);
}

}  // namespace
}  // namespace falciform
