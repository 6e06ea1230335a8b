// Displacement grids as ITK and 3D Slicer read them. The golden files were packed by Python from the formats'
// definitions, byte by byte, with no help from the writers under test.

#include "Logic/IO/DisplacementFiles.h"

#include <gmock/gmock.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>

#include <cstring>

#include "Logic/IO/ByteReader.h"
#include "Testing/Logic/IO/VolumeBytes.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

/// The grid of the golden files: left-handed, turned, uneven; every vector tells its voxel.
DisplacementGrid goldenGrid() {
  DisplacementGrid grid;
  grid.size = {3, 2, 2};
  grid.worldFromIndex << 1.5, -1.6, 0, 10, 2, 1.2, 0, -20, 0, 0, -3, 30.5, 0, 0, 0, 1;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i)
        grid.voxels.emplace_back(1.0F + static_cast<float>(i), 10.5F + 10 * static_cast<float>(j),
                                 -100.25F - 100 * static_cast<float>(k));
  return grid;
}

std::filesystem::path golden(const std::string& name) {
  return std::filesystem::path(FALCIFORM_SOURCE_DIR) / "Testing/Logic/IO/Golden" / name;
}

/// A NRRD's header and the floats behind it.
struct Parsed {
  std::string header;
  std::vector<float> values;
};
Parsed parsed(const std::filesystem::path& file) {
  const std::string bytes = readTextFile(file);
  Parsed result;
  const std::size_t end = bytes.find("\n\n") + 2;
  result.header = bytes.substr(0, end);
  result.values.resize(36);
  ByteReader reader(file, end, Packing::Deflated);
  EXPECT_EQ(reader.read(result.values.data(), 144), 144U);
  char more = 0;
  EXPECT_EQ(reader.read(&more, 1), 0U) << "bytes behind the vectors";
  return result;
}

TEST(DisplacementFiles, NrrdIsTheGoldenOne) {
  const TemporaryFolder folder;
  writeDisplacements(folder / "d.nrrd", goldenGrid(), Overwrite::Refuse);
  // Deflated bytes may differ between versions of zlib: what they hold may not.
  const Parsed ours = parsed(folder / "d.nrrd"), theirs = parsed(golden("displacement.nrrd"));
  EXPECT_EQ(ours.header, theirs.header);
  EXPECT_EQ(ours.values, theirs.values);
  // Components stand together, LPS: the second voxel's vector is floats 3 to 5.
  EXPECT_THAT(std::vector<float>(ours.values.begin() + 3, ours.values.begin() + 6),
              testing::ElementsAre(2, 10.5F, -100.25F));
}

TEST(DisplacementFiles, NiftiIsTheGoldenOneToTheByte) {
  const TemporaryFolder folder;
  writeDisplacements(folder / "d.nii", goldenGrid(), Overwrite::Refuse);
  const std::string ours = readTextFile(folder / "d.nii"), theirs = readTextFile(golden("displacement.nii"));
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t b = 0; b < ours.size(); ++b) EXPECT_EQ(ours[b], theirs[b]) << "byte " << b;
}

TEST(DisplacementFiles, DeflatedNiftiHoldsTheSameBytes) {
  const TemporaryFolder folder;
  writeDisplacements(folder / "d.nii.gz", goldenGrid(), Overwrite::Refuse);
  const std::string theirs = readTextFile(golden("displacement.nii"));
  std::string ours(theirs.size(), ' ');
  EXPECT_EQ(ByteReader(folder / "d.nii.gz", 0, Packing::Deflated).read(ours.data(), ours.size()),
            theirs.size());
  EXPECT_EQ(ours, theirs);
}

TEST(DisplacementFiles, VtkReadsTheNiftiWithRasVectorsInTheirPlaces) {
  const TemporaryFolder folder;
  const DisplacementGrid grid = goldenGrid();
  writeDisplacements(folder / "d.nii", grid, Overwrite::Refuse);
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName((folder / "d.nii").c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  ASSERT_EQ(image->GetNumberOfScalarComponents(), 3);
  vtkMatrix4x4* ras = reader->GetSFormMatrix();
  ASSERT_NE(ras, nullptr);
  // VTK turns the slices of a left-handed file round, and its matrix goes with spaced coordinates.
  ASSERT_EQ(reader->GetQFac(), -1);
  const double* spacing = image->GetSpacing();
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3f lps = grid.at(i, j, 1 - k);
        EXPECT_EQ(image->GetScalarComponentAsFloat(i, j, k, 0), -lps.x());
        EXPECT_EQ(image->GetScalarComponentAsFloat(i, j, k, 1), -lps.y());
        EXPECT_EQ(image->GetScalarComponentAsFloat(i, j, k, 2), lps.z());
        const double index[4] = {i * spacing[0], j * spacing[1], k * spacing[2], 1};
        double place[4];
        ras->MultiplyPoint(index, place);
        const Vector3d world = grid.world(Vector3d(i, j, 1 - k));
        // mm: the header holds single precision.
        EXPECT_NEAR(place[0], -world.x(), 1e-5);
        EXPECT_NEAR(place[1], -world.y(), 1e-5);
        EXPECT_NEAR(place[2], world.z(), 1e-5);
      }
}

TEST(DisplacementFiles, OtherNamesAndGridsAreRefused) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& name, const DisplacementGrid& grid) {
    return refusalOf([&] { writeDisplacements(folder / name, grid, Overwrite::Refuse); });
  };
  EXPECT_THAT(refusal("d.vtp", goldenGrid()), testing::HasSubstr(".nrrd"));
  EXPECT_THAT(refusal("d.seg.nrrd", goldenGrid()), testing::HasSubstr(".nrrd"));
  DisplacementGrid flat = goldenGrid();
  flat.worldFromIndex.col(2).setZero();
  EXPECT_FALSE(refusal("d.nrrd", flat).empty());
  EXPECT_FALSE(std::filesystem::exists(folder / "d.nrrd"));
}

}  // namespace
}  // namespace falciform::test
