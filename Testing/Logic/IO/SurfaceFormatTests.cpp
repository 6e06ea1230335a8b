#include <gmock/gmock.h>

#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/TemporaryFolder.h"

// Files as other programs write them, typed by hand.

namespace falciform {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Loaded<Surface> readText(const std::string& name, const std::string& text) {
  const TemporaryFolder folder;
  put(folder / name, text);
  return readSurface(folder / name);
}

Vector3d point(const Surface& surface, Index i) { return surface.points.row(i).transpose(); }

const std::string kTriangle = "v 10 20 30\nv 40 20 30\nv 10 60 30\nf 1 2 3\n";

TEST(SpaceTag, RasIsTurnedAndNormalsWithIt) {
  const auto [s, warnings] = readText("s.ply",
                                      "ply\nformat ascii 1.0\ncomment SPACE=RAS\nelement vertex 2\nproperty "
                                      "float x\nproperty float y\nproperty float z\n"
                                      "property float nx\nproperty float ny\nproperty float "
                                      "nz\nend_header\n1 2 3 0.6 0.8 0\n10 20 30 0 0 2\n");
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(point(s, 0), Vector3d(-1, -2, 3));
  EXPECT_LT((s.normals.row(0) - Eigen::RowVector3d(-0.6, -0.8, 0)).norm(), 1e-15);  // one rounding
  EXPECT_EQ(s.normals.row(1), Eigen::RowVector3d(0, 0, 1));
  EXPECT_EQ(s.frame, "LPS");
}

TEST(SpaceTag, IsHonouredInEveryFormat) {
  const std::string legacy = "\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n1 2 3 10 20 30\n";
  const std::string stl =
      "\nfacet normal 0 0 1\nouter loop\nvertex 1 2 3\nvertex 10 2 3\nvertex 1 20 "
      "3\nendloop\nendfacet\nendsolid\n";
  const std::vector<std::pair<std::string, std::string>> files{
      {"s.obj", "# SPACE=RAS\nv 1 2 3\nv 10 20 30\n"},
      {"s.vtk", "# vtk DataFile Version 3.0\n3D Slicer output. SPACE=RAS" + legacy},
      {"s.stl", "solid SPACE=RAS" + stl},
      {"s.xyz", "# SPACE=RAS; by hand\n1 2 3\n10 20 30\n"}};
  for (const auto& [name, text] : files) {
    const auto [s, warnings] = readText(name, text);
    EXPECT_THAT(warnings, IsEmpty()) << name;
    EXPECT_EQ(point(s, 0), Vector3d(-1, -2, 3)) << name;
  }
}

TEST(SpaceTag, IsMissedAloud) {
  const auto [s, warnings] = readText("s.obj", kTriangle);
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("LPS is assumed")));
  EXPECT_EQ(point(s, 0), Vector3d(10, 20, 30));
}

TEST(ObjFiles, TakesEveryFormOfFaceAndKeepsUnusedPoints) {
  const auto s =
      readText(
          "s.obj",
          "# SPACE=LPS\nmtllib x.mtl\nv 0 0 0\nv 9 9 9\nv 10 0 0\nvt 0 0\nvn 0 0 1\nv 10 10 0\nv 0 10 0\n"
          "usemtl a\ns off\nf 1/1/1 3/1/1 4//1 5/1\nf -5 -3 \\\n -2\nl 1 2\n")
          .value;
  EXPECT_EQ(s.size(), 5);
  Triangles expected(3, 3);
  expected << 0, 2, 3, 0, 3, 4, 0, 2, 3;
  EXPECT_EQ(s.triangles, expected);
}

TEST(ObjFiles, TakesVertexColoursInEitherRange) {
  EXPECT_EQ(readText("s.obj", "v 0 0 0 1 0 0.5\nv 9 9 9 0 1 0\n").value.colours(0, 2), 128);
  EXPECT_EQ(readText("s.obj", "v 0 0 0 255 0 17\nv 9 9 9 0 1 0\n").value.colours(0, 2), 17);
}

TEST(PlyFiles, BigEndianListsAndForeignPropertiesAreRead) {
  std::string text =
      "ply\r\nformat binary_big_endian 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\n"
      "property float z\r\nproperty short quality\r\nelement face 1\r\nproperty uchar flag\r\n"
      "property list uchar ushort vertex_index\r\nend_header\r\n";
  const auto big = [&](std::uint32_t value, int bytes) {
    while (bytes-- > 0) text += static_cast<char>(value >> (8 * bytes) & 0xFF);
  };
  for (const std::uint32_t x : {0x41200000u, 0x41A00000u, 0x41F00000u}) {  // 10, 20, 30
    big(x, 4), big(0x3F800000u, 4), big(x, 4);                             // y = 1
    big(0xFFFEu, 2);                                                       // -2
  }
  big(1, 1), big(3, 1), big(2, 2), big(1, 2), big(0, 2);
  const auto s = readText("s.ply", text).value;
  EXPECT_EQ(point(s, 2), Vector3d(30, 1, 30));
  EXPECT_EQ(s.arrays.at("quality"), VectorXd::Constant(3, -2));
  EXPECT_EQ(s.triangles.row(0), Eigen::RowVector3i(2, 1, 0));
}

TEST(StlFiles, TextFormMergesCorners) {
  const std::string facet =
      "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 10 0 -0.0\nvertex 0 1e1 0\nendloop\nendfacet\n";
  const std::string other =
      "facet normal 0 0 0\nouter loop\nvertex 10 0 0\nvertex 10 10 0\nvertex 0 10 0\nendloop\nendfacet\n";
  const auto s = readText("s.stl", "solid x\n" + facet + other + "endsolid x\n").value;
  EXPECT_EQ(s.size(), 4);
  EXPECT_EQ(s.triangles.row(1), Eigen::RowVector3i(1, 3, 2));
}

TEST(CloudTextFiles, UnderstandHeadersSeparatorsAndDecimalCommas) {
  const auto named =
      readText("s.csv", "# SPACE=LPS\nx;y;z;Patch;depth_mm\n1,5;2;3;1;7\n10;20;30;0;8\n").value;
  EXPECT_EQ(point(named, 0), Vector3d(1.5, 2, 3));
  EXPECT_THAT(named.patch, ElementsAre(1, 0));
  EXPECT_EQ(named.arrays.at("depth_mm")[1], 8);
  EXPECT_EQ(
      point(readText("s.csv", "\xEF\xBB\xBF\"X\", \"Y\", \"Z\"\r\n1, 2, 3\r\n+4, 5e1, -6\r\n").value, 1),
      Vector3d(4, 50, -6));
  EXPECT_EQ(point(readText("s.xyz", "1\t2\t3\n\n// comment\n4 5 60").value, 1), Vector3d(4, 5, 60));
}

TEST(CloudTextFiles, TellColoursFromNormals) {
  EXPECT_EQ(readText("s.xyz", "1 2 3 255 0 7\n4 5 6 0 0 0\n").value.colours(0, 2), 7);
  EXPECT_EQ(readText("s.xyz", "1 2 3 0 0 1\n4 5 6 0.6 0.8 0\n").value.normals.rows(), 2);
  const auto [s, warnings] = readText("s.xyz", "1 2 3 77.5\n4 5 6 1\n");
  EXPECT_EQ(s.size(), 2);
  EXPECT_THAT(warnings, testing::Contains(HasSubstr("columns 4 to 4")));
}

TEST(LegacyVtkFiles, StripsAndPolygonsAreCutAndFloatPatchesTaken) {
  const auto s =
      readText("s.vtk",
               "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 5 float\n"
               "0 0 0 10 0 0 10 10 0 0 10 0 5 5 9\nPOLYGONS 1 5\n4 0 1 2 3\nTRIANGLE_STRIPS 1 5\n4 0 1 3 4\n"
               "POINT_DATA 5\nSCALARS Patch float 1\nLOOKUP_TABLE default\n0 1 2 3 0\n")
          .value;
  EXPECT_EQ(s.triangles.rows(), 4);
  EXPECT_THAT(s.patch, ElementsAre(0, 1, 2, 3, 0));
  EXPECT_EQ(s.triangles.row(2),
            Eigen::RowVector3i(0, 1, 3));  // strips come after polygons, turned alternately
  EXPECT_EQ(s.triangles.row(3), Eigen::RowVector3i(3, 1, 4));
}

}  // namespace
}  // namespace falciform
