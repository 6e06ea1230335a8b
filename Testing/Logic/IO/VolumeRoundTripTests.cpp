#include <gmock/gmock.h>

#include <fstream>
#include <random>

#include "Logic/IO/VolumeFiles.h"
#include "Testing/Logic/IO/VolumeBytes.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {

namespace {

struct Grid {
  const char* name;
  Matrix4d worldFromIndex;
};

Matrix4d gridOf(const Matrix3d& axes, const Vector3d& spacing, const Vector3d& origin) {
  Matrix4d m = Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = axes * spacing.asDiagonal();
  m.topRightCorner<3, 1>() = origin;
  return m;
}

std::vector<Grid> grids() {
  const Matrix3d turned = randomMotion(3).linear();
  const Matrix3d mirrored = turned * Vector3d(1, 1, -1).asDiagonal();
  const Matrix3d permuted{{0, 0, -1}, {1, 0, 0}, {0, -1, 0}};
  Matrix3d tilted = Matrix3d::Identity();
  tilted.col(2) = Vector3d(0, std::sin(0.3), std::cos(0.3));
  const Vector3d spacing(0.743, 0.91, 2.5), origin(-179.25, 93.5, -341.125);
  return {{"upright", gridOf(Matrix3d::Identity(), {1, 1, 1}, {0, 0, 0})},
          {"anisotropic", gridOf(Vector3d(-1, -1, 1).asDiagonal(), spacing, origin)},
          {"oblique", gridOf(turned, spacing, origin)},
          {"left-handed", gridOf(mirrored, spacing, origin)},
          {"permuted", gridOf(permuted, spacing, origin)},
          {"tilted gantry", gridOf(tilted, spacing, origin)}};
}

const std::vector<std::string> kExtensions{".nii",  ".nii.gz", ".nrrd", ".seg.nrrd",
                                           ".nhdr", ".mha",    ".mhd",  ".NRRD"};

// NIfTI-1 stores float32 (24 bits of some 400 mm); the others store shortest exact decimals.
double toleranceMm(const std::string& extension) { return extension.starts_with(".nii") ? 1e-4 : 1e-9; }

template <class T>
Volume<T> filled(const Matrix4d& worldFromIndex, unsigned seed) {
  Volume<T> volume;
  volume.size = {7, 5, 11};
  volume.worldFromIndex = worldFromIndex;
  std::mt19937 draw(seed);
  for (int v = 0; v < volume.size.prod(); ++v)
    volume.voxels.push_back(static_cast<T>(
        std::is_same_v<T, float> ? static_cast<double>(draw() % 4096) / 3 - 1024 : draw() % 65536));
  return volume;
}

template <class T>
void expectSameVolume(const Volume<T>& found, const Volume<T>& expected, double mm, const std::string& what) {
  ASSERT_EQ(found.size, expected.size) << what;
  EXPECT_EQ(found.voxels, expected.voxels) << what;
  double farthest = 0;
  for (int k = 0; k < expected.size.z(); ++k)
    for (int j = 0; j < expected.size.y(); ++j)
      for (int i = 0; i < expected.size.x(); ++i)
        farthest =
            std::max(farthest, (found.world(Vector3d(i, j, k)) - expected.world(Vector3d(i, j, k))).norm());
  EXPECT_LE(farthest, mm) << what;
}

std::string fileBytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST(VolumeRoundTrip, EveryVoxelKeepsItsValueAndItsPlaceInTheWorld) {
  const TemporaryFolder folder;
  for (const Grid& grid : grids())
    for (const std::string& extension : kExtensions) {
      const std::string what = std::string(grid.name) + " " + extension;
      const auto labels = filled<std::uint16_t>(grid.worldFromIndex, 1);
      const auto image = filled<float>(grid.worldFromIndex, 2);
      writeLabelMap(folder / ("labels" + extension), labels, Overwrite::Replace);
      writeImage(folder / ("image" + extension), image, Overwrite::Replace);
      const auto labelsBack = readLabelMap(folder / ("labels" + extension));
      const auto imageBack = readImage(folder / ("image" + extension));
      expectSameVolume(labelsBack.value, labels, toleranceMm(extension), what);
      expectSameVolume(imageBack.value, image, toleranceMm(extension), what);
      const bool tilted = std::string(grid.name) == "tilted gantry";
      EXPECT_EQ(labelsBack.warnings.size(), tilted ? 1U : 0U) << what;
    }
}

TEST(VolumeRoundTrip, QformOfTheWriterSaysTheSameAsItsSform) {
  const TemporaryFolder folder;
  for (const Grid& grid : grids()) {
    const auto labels = filled<std::uint16_t>(grid.worldFromIndex, 1);
    writeLabelMap(folder / "both.nii", labels, Overwrite::Replace);
    std::string bytes = fileBytes(folder / "both.nii");
    const bool hasQform = bytes[252] == 1;
    EXPECT_EQ(hasQform, std::string(grid.name) != "tilted gantry") << "a quaternion cannot say a shear";
    if (!hasQform) continue;
    bytes[254] = 0;  // sform_code
    const auto back = readLabelMap(writeBytes(folder / "qform.nii", bytes));
    expectSameVolume(back.value, labels, toleranceMm(".nii"), grid.name);
  }
}

TEST(VolumeRoundTrip, WritingTwiceGivesTheSameBytes) {
  const TemporaryFolder folder;
  const auto labels = filled<std::uint16_t>(grids()[2].worldFromIndex, 1);
  for (const std::string& extension : kExtensions) {
    writeLabelMap(folder / ("a" + extension), labels, Overwrite::Refuse);
    const std::string first = fileBytes(folder / ("a" + extension));
    writeLabelMap(folder / ("a" + extension), labels, Overwrite::Replace);
    EXPECT_EQ(first, fileBytes(folder / ("a" + extension))) << extension;
  }
}

TEST(VolumeRoundTrip, AnExistingFileIsReplacedOnlyOnRequest) {
  const TemporaryFolder folder;
  const auto labels = filled<std::uint16_t>(Matrix4d::Identity(), 1);
  for (const std::string& extension : kExtensions) {
    const auto file = writeBytes(folder / ("old" + extension), "precious");
    EXPECT_THAT(refusalOf([&] { writeLabelMap(file, labels, Overwrite::Refuse); }),
                ::testing::HasSubstr("exists already"));
    EXPECT_EQ(fileBytes(file), "precious");
    EXPECT_FALSE(std::filesystem::exists(folder / "old.zraw")) << "no voxels without their header";
  }
}

TEST(VolumeRoundTrip, SegmentsAreNamedForSlicer) {
  const TemporaryFolder folder;
  auto labels = filled<std::uint16_t>(Matrix4d::Identity(), 1);
  for (auto& value : labels.voxels) value = value % 3 == 0 ? 0 : value % 3 == 1 ? 4 : 9;
  writeLabelMap(folder / "a.seg.nrrd", labels, Overwrite::Refuse);
  EXPECT_EQ(readLabelNames(folder / "a.seg.nrrd"),
            (std::map<int, std::string>{{4, "Label 4"}, {9, "Label 9"}}));
}

TEST(VolumeRoundTrip, WritingRefusesWhatAFormatCannotHold) {
  const TemporaryFolder folder;
  LabelMap longOne;
  longOne.size = {40000, 1, 1};
  longOne.voxels.assign(40000, 1);
  EXPECT_THAT(refusalOf([&] { writeLabelMap(folder / "long.nii", longOne, Overwrite::Refuse); }),
              ::testing::HasSubstr(".nrrd"));
  writeLabelMap(folder / "long.nrrd", longOne, Overwrite::Refuse);
  EXPECT_EQ(readLabelMap(folder / "long.nrrd").value.voxels, longOne.voxels);
  EXPECT_THAT(refusalOf([&] { writeLabelMap(folder / "map.png", longOne, Overwrite::Refuse); }),
              ::testing::HasSubstr(".png"));
  EXPECT_THAT(refusalOf([&] { writeLabelMap(folder / "empty.mha", {}, Overwrite::Refuse); }),
              ::testing::HasSubstr("0 x 0 x 0"));
  EXPECT_FALSE(isVolumeFile("a.vtp"));
  EXPECT_TRUE(isVolumeFile("A.NII.GZ"));
}

}  // namespace falciform::test
