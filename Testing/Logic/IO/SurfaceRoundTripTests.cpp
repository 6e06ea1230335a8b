#include <gmock/gmock.h>

#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform {
namespace {

using namespace test;
using testing::IsEmpty;

Loaded<Surface> throughFile(const Surface& surface, const std::string& name) {
  const TemporaryFolder folder;
  writeSurface(folder / name, surface, Overwrite::Refuse);
  EXPECT_EQ(entriesIn(folder.path()), 1) << "a temporary file is left";
  return readSurface(folder / name);
}

void expectSamePatches(const Surface& read, const Surface& written) {
  EXPECT_EQ(read.patch, written.patch);
  EXPECT_EQ(read.patchNames, written.patchNames);
}

class KeepsEverything : public testing::TestWithParam<const char*> {};

TEST_P(KeepsEverything, PointsTrianglesArraysAndNames) {
  const Surface surface = fullSurface();
  const auto [read, warnings] = throughFile(surface, std::string("s") + GetParam());
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(read.points, surface.points);  // doubles are stored as they are
  EXPECT_EQ(read.triangles, surface.triangles);
  EXPECT_EQ(read.colours, surface.colours);
  EXPECT_LT((read.normals - surface.normals).cwiseAbs().maxCoeff(), 1e-15);  // normalised again: one rounding
  EXPECT_EQ(read.arrays, surface.arrays);
  EXPECT_EQ(read.frame, "LPS");
  expectSamePatches(read, surface);
}

INSTANTIATE_TEST_SUITE_P(Formats, KeepsEverything, testing::Values(".vtp", ".vtk", ".VTP"));

TEST(SurfaceFiles, PlyKeepsColoursNormalsAndPatches) {
  const Surface surface = fullSurface();
  const auto [read, warnings] = throughFile(surface, "s.ply");
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(read.points, surface.points);
  EXPECT_EQ(read.triangles, surface.triangles);
  EXPECT_EQ(read.colours, surface.colours);
  EXPECT_LT((read.normals - surface.normals).cwiseAbs().maxCoeff(), 1e-15);
  expectSamePatches(read, surface);
  EXPECT_THAT(read.arrays, IsEmpty());
}

TEST(SurfaceFiles, ObjKeepsPointsInTheirOrderToTheLastBit) {
  const Surface surface = fullSurface();
  const auto [read, warnings] = throughFile(surface, "s.obj");
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(read.points, surface.points);
  EXPECT_EQ(read.triangles, surface.triangles);
  EXPECT_TRUE(read.patch.empty());
}

TEST(SurfaceFiles, StlComesBackConnected) {
  const Surface surface = fullSurface();
  const auto [read, warnings] = throughFile(surface, "s.stl");
  EXPECT_THAT(warnings, IsEmpty());
  ASSERT_EQ(read.size(), surface.size());  // 162 again, not 3 a triangle
  ASSERT_EQ(read.triangles.rows(), surface.triangles.rows());
  for (Index i = 0; i < read.triangles.rows(); ++i)
    for (Index k = 0; k < 3; ++k) {
      const Vector3d difference =
          read.points.row(read.triangles(i, k)) - surface.points.row(surface.triangles(i, k));
      EXPECT_LT(difference.norm(), 2e-5);  // mm: floats of about 100 mm
    }
}

class Clouds : public testing::TestWithParam<const char*> {};

TEST_P(Clouds, StayCloudsAndKeepTheScannersFrame) {
  Surface cloud = fullSurface();
  cloud.triangles.resize(0, 3);
  cloud.frame = "da Vinci scanner";
  const auto [read, warnings] = throughFile(cloud, std::string("s") + GetParam());
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(read.points, cloud.points);
  EXPECT_EQ(read.triangles.rows(), 0);
  EXPECT_EQ(read.frame, "da Vinci scanner");
}

INSTANTIATE_TEST_SUITE_P(Formats, Clouds, testing::Values(".vtp", ".vtk", ".ply", ".obj"));

TEST(SurfaceFiles, StlRefusesACloud) {
  const TemporaryFolder folder;
  Surface cloud = fullSurface();
  cloud.triangles.resize(0, 3);
  EXPECT_THROW(writeSurface(folder / "s.stl", cloud, Overwrite::Refuse), InputError);
  EXPECT_EQ(entriesIn(folder.path()), 0);
}

TEST(SurfaceFiles, TwoPointsAreEnough) {
  Surface pair;
  pair.points.resize(2, 3);
  pair.points << 0, 0, 0, 10, 20, 30;
  for (const char* name : {"s.vtp", "s.vtk", "s.ply", "s.obj"})
    EXPECT_EQ(throughFile(pair, name).value.points, pair.points);
}

TEST(SurfaceFiles, LegacyVtkIsWrittenInVersionFourWithTheTagInItsTitle) {
  const TemporaryFolder folder;
  writeSurface(folder / "s.vtk", fullSurface(), Overwrite::Refuse);
  const std::string bytes = readTextFile(folder / "s.vtk");
  EXPECT_TRUE(bytes.starts_with("# vtk DataFile Version 4.2\n3D Slicer output. SPACE=LPS\n"))
      << bytes.substr(0, 80);
}

TEST(SurfaceFiles, ScalingTurnsMetresIntoMillimetres) {
  const Surface surface = fullSurface();
  const Surface metres = scaled(surface, 0.001);
  EXPECT_EQ(throughFile(metres, "s.ply").warnings.size(), 1u);
  EXPECT_LT((scaled(metres, 1000).points - surface.points).cwiseAbs().maxCoeff(),
            1e-12);  // mm: two roundings
}

}  // namespace
}  // namespace falciform
