#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "Logic/IO/VolumeFiles.h"
#include "Testing/Logic/IO/DicomBytes.h"
#include "Testing/Logic/IO/VolumeBytes.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {

namespace {

using testing::HasSubstr;

std::filesystem::path put(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::create_directories(file.parent_path());
  return writeBytes(file, bytes);
}

SlicePlan valued(int value) {
  SlicePlan plan;
  plan.values.assign(12, value);
  return plan;
}

/// Slices of one value each, that is their place, in a scrambled order of names.
void writeRamp(const std::filesystem::path& folder, const std::vector<double>& z) {
  for (std::size_t s = 0; s < z.size(); ++s) {
    SlicePlan plan = valued(static_cast<int>(10 * z[s]));
    plan.intercept = "0";
    plan.instance = "1.2.3." + std::to_string(s);
    plan.position = "0\\0\\" + std::to_string(z[s]);
    put(folder / ("im" + std::to_string((3 * s + 1) % z.size())), dicomSlice(plan));
  }
}

}  // namespace

TEST(DicomSeries, SlicesAreSortedByPlaceAndThicknessIsNoSpacing) {
  const TemporaryFolder folder;
  writeRamp(folder.path(), {4, 0, 8, 2, 6});  // 2 mm apart, each said to be 5 mm thick
  const auto image = readImage(folder.path());
  ASSERT_EQ(image.value.size, Vector3i(4, 3, 5));
  EXPECT_EQ(image.value.spacing(), Vector3d(1.5, 2, 2)) << "mm: PixelSpacing gives rows first";
  for (int k = 0; k < 5; ++k) EXPECT_EQ(image.value.at(1, 1, k), 20 * k) << "slice " << k;
  EXPECT_TRUE(image.warnings.empty());
}

TEST(DicomSeries, ObliqueSlicesLieWhereTheHeaderPutsThem) {
  const TemporaryFolder folder;
  // Rows run towards -y, columns towards -z: a sagittal series; the normal is +x.
  SlicePlan plan;
  plan.orientation = "0\\-1\\0\\0\\0\\-1";
  for (int s = 0; s < 3; ++s) {
    plan.position = std::to_string(10 + 3 * s) + "\\20\\30";
    plan.instance = "1.2." + std::to_string(s);
    put(folder / std::to_string(9 - s), dicomSlice(plan));
  }
  const auto image = readImage(folder.path());
  EXPECT_EQ(image.value.world({0, 0, 0}), Vector3d(10, 20, 30));
  EXPECT_EQ(image.value.world({1, 0, 0}), Vector3d(10, 18.5, 30)) << "one column on: PixelSpacing's second";
  EXPECT_EQ(image.value.world({0, 1, 0}), Vector3d(10, 20, 28)) << "one row on: PixelSpacing's first";
  EXPECT_EQ(image.value.world({0, 0, 1}), Vector3d(13, 20, 30));
}

TEST(DicomSeries, SeveralSeriesAreListedAndMustBeChosen) {
  const TemporaryFolder folder;
  SlicePlan portal, arterial;
  portal.description = "portal phase";
  arterial.description = "arterial";
  arterial.series = "1.2.3.5";
  arterial.instance = "1.2.3.5";
  arterial.intercept = "0";
  writeSeries(folder / "b", portal, {0, 2, 4});
  writeSeries(folder / "a/deeper", arterial, {0, 1});
  put(folder / "notes.txt", "nothing of DICOM");
  put(folder / "DICOMDIR", dicomFile(DicomBytes().text(0x00080016, "UI", "1.2.840.10008.1.3.10")));
  const auto listing = listDicom(folder.path());
  ASSERT_EQ(listing.series.size(), 2u);
  EXPECT_EQ(listing.otherFiles, 1u);
  EXPECT_EQ(listing.series[0].description, "arterial");
  EXPECT_EQ(listing.series[0].files, 2u);
  EXPECT_EQ(listing.series[1].size, Vector3i(4, 3, 3));
  const std::string refusal = refusalOf([&] { (void)readImage(folder.path()); });
  EXPECT_THAT(refusal, HasSubstr("--series"));
  EXPECT_THAT(refusal,
              HasSubstr("2: CT 'portal phase', 4 x 3 x 3 voxels of 1.500 x 2.000 x 2.000 mm, 3 files"));
  EXPECT_EQ(readImage(folder.path(), "1").value.at(1, 0, 0), 1);
  EXPECT_EQ(readImage(folder.path(), "2").value.at(1, 0, 0), 1 - 1024);
  EXPECT_EQ(readImage(folder.path(), listing.series[1].code).value.size.z(), 3);
  EXPECT_EQ(readImage(folder / "b/slice_1").value.size.z(), 3) << "a file stands for its series";
  EXPECT_THAT(refusalOf([&] { (void)readImage(folder.path(), "3"); }), HasSubstr("no DICOM series"));
}

TEST(DicomSeries, MissingAndUnevenSlicesAreInterpolatedAndNamed) {
  const TemporaryFolder folder;
  writeRamp(folder.path(), {0, 2, 4, 8, 10, 12, 14, 16, 18, 20});  // 6 mm is missing
  const auto image = readImage(folder.path());
  ASSERT_EQ(image.value.size.z(), 11);
  for (int k = 0; k < 11; ++k) EXPECT_NEAR(image.value.at(0, 0, k), 20 * k, 1e-4) << "linear in place";
  EXPECT_TRUE(warns(image.warnings, "4.00 mm after slice 3 (1 slices seem to be missing)"));
  EXPECT_TRUE(warns(image.warnings, "interpolated"));
}

TEST(DicomSeries, TooMuchMissingIsRefused) {
  const TemporaryFolder folder;
  writeRamp(folder.path(), {0, 2, 4, 6, 8, 20, 22, 24, 26, 28});
  EXPECT_THAT(refusalOf([&] { (void)readImage(folder.path()); }), HasSubstr("12.00 mm after slice 5"));
  EXPECT_EQ(listDicom(folder.path()).series.size(), 1u) << "listed with the reason";
}

TEST(DicomSeries, SlicesRoundedToTwoDecimalsAreEven) {
  const TemporaryFolder folder;
  writeRamp(folder.path(), {0, 0.67, 1.33, 2.0, 2.67, 3.33, 4.0});
  const auto image = readImage(folder.path());
  EXPECT_EQ(image.value.size.z(), 7);
  EXPECT_TRUE(image.warnings.empty());
  EXPECT_NEAR(image.value.spacing().z(), 4.0 / 6, 1e-12) << "mm, over the whole length";
}

TEST(DicomSeries, CopiesAreDroppedAndDifferentSlicesAtOnePlaceRefused) {
  const TemporaryFolder folder;
  writeSeries(folder / "one", {}, {0, 2, 4});
  std::filesystem::copy(folder / "one/slice_1", folder / "one/again");
  const auto image = readImage(folder / "one");
  EXPECT_EQ(image.value.size.z(), 3);
  EXPECT_TRUE(warns(image.warnings, "1 copies"));
  SlicePlan other = valued(7);
  other.instance = "9.9";
  other.position = "0\\0\\2";
  put(folder / "one/other", dicomSlice(other));
  EXPECT_THAT(refusalOf([&] { (void)readImage(folder / "one"); }),
              HasSubstr("different slices lie at the same place"));
}

TEST(DicomSeries, PhasesInOneSeriesArePartedByAcquisition) {
  const TemporaryFolder folder;
  SlicePlan second = valued(500);
  second.acquisition = 2;
  second.instance = "7.7";
  writeSeries(folder / "x", {}, {0, 2, 4});
  writeSeries(folder / "y", second, {0, 2, 4});
  for (int s = 0; s < 3; ++s)
    std::filesystem::rename(folder / ("y/slice_" + std::to_string(s)),
                            folder / ("x/other" + std::to_string(s)));
  const auto listing = listDicom(folder.path());
  ASSERT_EQ(listing.series.size(), 2u);
  EXPECT_NE(listing.series[0].code, listing.series[1].code);
  EXPECT_EQ(readImage(folder.path(), "2").value.at(0, 0, 0), 500 - 1024);
}

TEST(DicomSeries, TiltedGantryMakesAShearedGridAndIsReported) {
  const TemporaryFolder folder;
  SlicePlan plan;
  for (int s = 0; s < 4; ++s) {
    plan.position = "0\\" + std::to_string(s) + "\\" + std::to_string(2 * s);
    plan.instance = "5." + std::to_string(s);
    put(folder / std::to_string(s), dicomSlice(plan));
  }
  const auto image = readImage(folder.path());
  EXPECT_EQ(image.value.world({0, 0, 3}), Vector3d(0, 3, 6));
  EXPECT_TRUE(warns(image.warnings, "tilted by 26.57 degrees"));  // atan(1/2)
}

TEST(DicomSeries, SlicesShiftedUnevenlyAreRefused) {
  const TemporaryFolder folder;
  SlicePlan plan;
  for (int s = 0; s < 4; ++s) {
    plan.position = std::string(s == 2 ? "1.5" : "0") + "\\0\\" + std::to_string(2 * s);
    plan.instance = "5." + std::to_string(s);
    put(folder / std::to_string(s), dicomSlice(plan));
  }
  EXPECT_THAT(refusalOf([&] { (void)readImage(folder.path()); }), HasSubstr("shifted sideways"));
}

TEST(DicomSeries, DamagedFilesAreCountedAndASingleSliceIsNoVolume) {
  const TemporaryFolder folder;
  writeSeries(folder.path(), {}, {0, 2, 4});
  const std::string good = dicomSlice({});
  put(folder / "cut", good.substr(0, good.size() - 10));
  const auto listing = listDicom(folder.path());
  ASSERT_EQ(listing.unreadable.size(), 1u);
  EXPECT_THAT(listing.unreadable[0], HasSubstr("1 DICOM file left out"));
  EXPECT_EQ(listing.series.at(0).files, 3u);
  put(folder / "alone/one", good);
  EXPECT_THAT(refusalOf([&] { (void)readImage(folder / "alone"); }), HasSubstr("single slice"));
  put(folder / "text/a.txt", "hello");
  EXPECT_THAT(refusalOf([&] { (void)listDicom(folder / "text"); }), HasSubstr("no DICOM series"));
}

TEST(DicomSeries, NothingThatIsReadNamesThePatient) {
  const TemporaryFolder folder;
  SlicePlan plan;
  plan.description = "Portal of Surname, Marker 1983-07-04 19830704";
  writeSeries(folder / "MARKER", plan, {0, 2, 4});
  put(folder / "seg/one", dicomSegmentation());
  const auto listing = listDicom(folder.path());
  ASSERT_EQ(listing.series.size(), 2u);
  std::string seen;
  for (const DicomSeries& series : listing.series) {
    seen += describeSeries(series, 1) + series.description + series.code + series.refusal;
    for (const auto& warning : series.warnings) seen += warning;
    for (const auto& [label, name] : series.segments) seen += name;
  }
  EXPECT_FALSE(tellsIdentity(seen)) << seen;
  EXPECT_THAT(seen, HasSubstr("Portal of"));
  EXPECT_FALSE(tellsIdentity(refusalOf([&] { (void)readImage(folder.path(), "9"); })));
  EXPECT_FALSE(
      tellsIdentity(refusalOf([&] { (void)readDicomLabels(chooseSeries(listDicom(folder / "seg"), "7")); })));
}

}  // namespace falciform::test
