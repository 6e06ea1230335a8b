#include <gmock/gmock.h>

#include <cmath>

#include "Logic/Geometry/Topology.h"
#include "Logic/IO/ImageFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Logic/IO/ScanSamples.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform {
namespace {

using namespace test;
using testing::HasSubstr;

/// The grid of SmallSurfaces with a photograph laid over it.
Surface texturedGrid() {
  Surface surface = grid(10, 5);
  surface.textureAt = (surface.points.leftCols<2>() / 10).cast<float>();
  surface.texture = std::make_shared<const ColourImage>(gradientImage(64, 32));
  surface.colours = coloursAt(*surface.texture, surface.textureAt);
  return surface;
}

class Textures : public testing::TestWithParam<const char*> {
 protected:
  TemporaryFolder folder;
};

TEST_P(Textures, ComeBackWithTheSurface) {
  const Surface surface = texturedGrid();
  const auto file = folder / (std::string("scan.") + GetParam());
  writeSurface(file, surface, Overwrite::Refuse);
  const Surface read = readSurface(file).value;
  ASSERT_EQ(read.textureAt.rows(), surface.size());
  EXPECT_LT((read.textureAt - surface.textureAt).cwiseAbs().maxCoeff(), 1e-6F);
  ASSERT_TRUE(read.texture);
  EXPECT_EQ(read.texture->rgb, surface.texture->rgb);
  EXPECT_EQ(read.colours, surface.colours);
  EXPECT_EQ(read.triangles, surface.triangles);
}

TEST_P(Textures, AMissingOrDamagedImageCostsTheTextureAndIsWarnedOf) {
  const auto file = folder / (std::string("scan.") + GetParam());
  writeSurface(file, texturedGrid(), Overwrite::Refuse);
  put(folder / "scan_texture.png", "no picture");
  for (const char* words : {"without its texture", "texture"}) {
    const Loaded<Surface> loaded = readSurface(file);
    EXPECT_THAT(loaded.warnings, testing::Contains(HasSubstr(words)));
    EXPECT_EQ(loaded.value.textureAt.rows(), 0);
    EXPECT_FALSE(loaded.value.texture);
    std::filesystem::remove(folder / "scan_texture.png");
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, Textures, testing::Values("vtp", "vtk", "ply", "obj"));

TEST(TexturedSurfaces, AnExistingImageIsNotOverwrittenUnasked) {
  const TemporaryFolder folder;
  put(folder / "scan_texture.png", "mine");
  EXPECT_THAT(refusalOf([&] { writeSurface(folder / "scan.vtp", texturedGrid(), Overwrite::Refuse); }),
              HasSubstr("scan_texture.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "scan.vtp"));
}

TEST(TexturedSurfaces, PartsKeepTheirPlacesInTheImage) {
  const Surface surface = texturedGrid();
  const Surface part = subset(surface, {3, 4, 20});
  EXPECT_EQ(part.texture, surface.texture);
  EXPECT_EQ(part.textureAt.row(2), surface.textureAt.row(20));
}

TEST(TexturedSurfaces, ASeamKeepsTheSurfaceWholeAndHasNoPlace) {
  const TemporaryFolder folder;
  writePng(folder / "skin.png", gradientImage(64, 32), Overwrite::Refuse);
  // Two triangles with an edge between them; point 3 has two places.
  put(folder / "s.obj",
      "mtllib s.mtl\nv 0 0 0\nv 9 0 0\nv 0 9 0\nv 9 9 0\nvt 0.1 0.1\nvt 0.5 0.1\nvt 0.1 0.9\nvt 0.9 0.9\n"
      "vt 0.2 0.9\nusemtl m\nf 1/1 2/2 3/3\nf 2/2 4/4 3/5\n");
  put(folder / "s.mtl", "newmtl m\nKd 1 1 1\nmap_Kd -s 1 1 1 textures\\skin.png\n");
  const Loaded<Surface> loaded = readSurface(folder / "s.obj");
  const Surface& read = loaded.value;
  EXPECT_EQ(read.size(), 4);
  EXPECT_EQ(inspectTopology(read).boundaryEdges, 4);
  ASSERT_TRUE(read.texture) << (loaded.warnings.empty() ? "" : loaded.warnings[0]);
  EXPECT_TRUE(read.textureAt.row(0).allFinite());
  EXPECT_TRUE(std::isnan(read.textureAt(2, 0)));
  EXPECT_EQ(read.colours(2, 0), 6);  // from its first place: column 0.1 * 64 - 0.5 = 5.9
}

TEST(TexturedSurfaces, SeveralImagesGiveColoursByMaterial) {
  const TemporaryFolder folder;
  ColourImage red{2, 2, std::vector<std::uint8_t>(12, 0)}, blue = red;
  for (std::size_t i = 0; i < 12; i += 3) red.rgb[i] = blue.rgb[i + 2] = 200;
  writePng(folder / "red.png", red, Overwrite::Refuse);
  writePng(folder / "blue.png", blue, Overwrite::Refuse);
  put(folder / "s.obj",
      "mtllib s.mtl\nv 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nv 9 0 9\nv 0 9 9\nvt 0.5 0.5\n"
      "usemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 4/1 5/1 6/1\n");
  put(folder / "s.mtl", "newmtl a\nmap_Kd red.png\nnewmtl b\nmap_Kd blue.png\n");
  const Surface read = readSurface(folder / "s.obj").value;
  EXPECT_FALSE(read.texture);
  EXPECT_EQ(read.colours(0, 0), 200);
  EXPECT_EQ(read.colours(4, 2), 200);
}

TEST(TexturedSurfaces, MeshLabsCornerPlacesAreRead) {
  const TemporaryFolder folder;
  writePng(folder / "skin.png", gradientImage(64, 32), Overwrite::Refuse);
  put(folder / "s.ply",
      "ply\nformat ascii 1.0\ncomment TextureFile skin.png\nelement vertex 3\nproperty float x\nproperty "
      "float "
      "y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nproperty list uchar "
      "float "
      "texcoord\nend_header\n0 0 0\n9 0 0\n0 9 0\n3 0 1 2 6 0.1 0.2 0.5 0.2 0.1 0.9\n");
  const Surface read = readSurface(folder / "s.ply").value;
  ASSERT_TRUE(read.texture);
  EXPECT_EQ(read.textureAt.row(1), Eigen::RowVector2f(0.5F, 0.2F));
}

}  // namespace
}  // namespace falciform
