#include <gdcmTransferSyntax.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Logic/IO/VolumeFiles.h"
#include "Testing/Logic/IO/DicomBytes.h"
#include "Testing/Logic/IO/PackedSlice.h"
#include "Testing/Logic/IO/VolumeBytes.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {

namespace {

using testing::HasSubstr;

/// Two slices of `plan`, read as a volume.
Image readBack(SlicePlan plan) {
  const TemporaryFolder folder;
  writeSeries(folder.path(), std::move(plan), {0, 3});
  return readImage(folder.path()).value;
}

LabelMap readLabelsBack(SlicePlan plan) {
  const TemporaryFolder folder;
  writeSeries(folder.path(), std::move(plan), {0, 3});
  return readLabelMap(folder.path()).value;
}

}  // namespace

TEST(DicomPixels, EverySyntaxGivesTheSameValues) {
  for (const DicomSyntax syntax :
       {DicomSyntax::ImplicitLittle, DicomSyntax::ExplicitLittle, DicomSyntax::ExplicitBig}) {
    SlicePlan plan;
    plan.syntax = syntax;
    plan.slope = "2.5";
    const Image image = readBack(plan);
    for (std::size_t p = 0; p < 12; ++p) EXPECT_EQ(image.voxels[p], 2.5f * static_cast<float>(p) - 1024);
  }
}

TEST(DicomPixels, StoredBitsAreCutOutAndSignExtended) {
  SlicePlan plan;
  plan.intercept = "0";
  plan.isSigned = 1;
  plan.values = {0x0FFF, 0x0800, 0x07FF, 0xF001, 0, 1, 2, 3, 4, 5, 6, 7};  // 12 bits; an overlay above them
  std::vector<float> first = readBack(plan).voxels;
  first.resize(4);
  EXPECT_THAT(first, testing::ElementsAre(-1, -2048, 2047, 1));
  plan.isSigned = 0;
  EXPECT_EQ(readBack(plan).voxels[0], 4095);
  plan.stored = 8;  // of bits 4 to 11
  EXPECT_EQ(readBack(plan).voxels[1], 0x80);
  plan = {};
  plan.intercept = "0";
  plan.bits = plan.stored = 16;
  plan.highBit = 15;
  plan.values.assign(12, 0xFFFE);
  EXPECT_EQ(readBack(plan).voxels[0], 65534);
  plan.isSigned = 1;
  EXPECT_EQ(readBack(plan).voxels[0], -2);
  plan.bits = plan.stored = 8;
  plan.highBit = 7;
  plan.values.assign(12, 0x80);
  EXPECT_EQ(readBack(plan).voxels[0], -128);
}

TEST(DicomPixels, Monochrome1IsAMatterOfDisplay) {
  SlicePlan plan;
  plan.photometric = "MONOCHROME1";
  EXPECT_EQ(readBack(plan).voxels, readBack({}).voxels);
  plan.photometric = "RGB";
  EXPECT_THAT(refusalOf([&] { (void)readBack(plan); }), HasSubstr("colours"));
}

TEST(DicomPixels, LosslessCodersGiveTheValuesBack) {
  using TS = gdcm::TransferSyntax;
  for (const int stored : {8, 12, 16})
    for (const auto syntax : {TS::RLELossless, TS::JPEGLosslessProcess14_1, TS::JPEG2000Lossless}) {
      const SlicePlan plain = patternedSlice(stored);
      const Image image = readBack(packedSlice(plain, syntax));
      for (std::size_t p = 0; p < plain.values.size(); ++p)
        ASSERT_EQ(image.voxels[p], plain.values[p])
            << TS(syntax).GetString() << ", " << stored << " bits, pixel " << p;
    }
}

TEST(DicomPixels, LossyJpegIsNearTheValues) {
  SlicePlan plain = patternedSlice(8);
  for (std::size_t p = 0; p < plain.values.size(); ++p) plain.values[p] = static_cast<int>(40 + 8 * (p % 16));
  const Image image = readBack(packedSlice(plain, gdcm::TransferSyntax::JPEGBaselineProcess1));
  for (std::size_t p = 0; p < plain.values.size(); ++p)
    ASSERT_NEAR(image.voxels[p], plain.values[p], 6) << "grey values of 256; a smooth ramp in 8 x 8 blocks";
}

TEST(DicomPixels, CodedSliceOfAnotherSizeIsRefusedBeforeItIsDecoded) {
  using TS = gdcm::TransferSyntax;
  for (const auto syntax : {TS::RLELossless, TS::JPEGLosslessProcess14_1, TS::JPEG2000Lossless}) {
    SlicePlan plan = packedSlice(patternedSlice(12), syntax);
    plan.rows = 13;
    EXPECT_FALSE(tellsIdentity(refusalOf([&] { (void)readBack(plan); })));
    plan.rows = 12;
    plan.coded[0].resize(plan.coded[0].size() / 2);
    try {
      (void)readBack(plan);  // OpenJPEG may take half a stream for a coarse picture
    } catch (const InputError&) {
    }
  }
}

TEST(DicomPixels, UnknownCompressionIsNamed) {
  SlicePlan plan = packedSlice(patternedSlice(8), gdcm::TransferSyntax::RLELossless);
  plan.transferSyntax = "1.2.840.10008.1.2.4.100";  // MPEG
  EXPECT_THAT(refusalOf([&] { (void)readBack(plan); }), HasSubstr("compressed in a way that is not known"));
  plan.transferSyntax = "1.2.840.10008.1.2.4.80";  // JPEG-LS
  EXPECT_THAT(refusalOf([&] { (void)readBack(plan); }), HasSubstr("export it uncompressed"));
}

TEST(DicomPixels, MaskSeriesIsALabelMapAndACtIsNot) {
  SlicePlan plan;
  plan.bits = plan.stored = 8;
  plan.highBit = 7;
  plan.intercept = "0";
  plan.values = {0, 255, 0, 255, 0, 0, 0, 0, 0, 0, 0, 255};
  const LabelMap mask = readLabelsBack(plan);
  EXPECT_EQ(mask.voxels[0], 0);
  EXPECT_EQ(mask.voxels[1], 1);
  plan.intercept = "-1024";  // left over from the CT
  EXPECT_EQ(readLabelsBack(plan).voxels, mask.voxels);
  plan.intercept = "0";
  plan.values = {0, 1, 2, 3, 3, 3, 0, 0, 0, 0, 0, 8};
  EXPECT_EQ(readLabelsBack(plan).voxels[11], 8) << "labels as they are";
  EXPECT_THAT(refusalOf([&] { (void)readLabelsBack({}); }), HasSubstr("intensities"));
}

TEST(DicomPixels, SegmentationBecomesLabelsWithNamesInPlace) {
  const TemporaryFolder folder;
  const auto named = readNamedLabels(writeBytes(folder / "segments", dicomSegmentation()));
  EXPECT_EQ(named.value.names, (std::map<int, std::string>{{1, "Liver"}, {2, "Tumour of"}}));
  const LabelMap& map = named.value.map;
  ASSERT_EQ(map.size, Vector3i(8, 4, 3));
  EXPECT_EQ(map.world({0, 0, 0}), Vector3d(10, 20, 0));
  EXPECT_EQ(map.spacing(), Vector3d(1, 1, 2)) << "mm; its slices are said to be 5 mm thick";
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 8; ++i)
      EXPECT_EQ(map.at(i, 2, k), i > 3 ? 0 : i == 3 && k > 0 ? 2 : 1) << "column " << i << ", slice " << k;
  EXPECT_TRUE(warns(named.warnings, "8 voxels belong to several segments"));
}

TEST(DicomPixels, MasksOfAFolderAreOneMapWithTheSmallestOnTop) {
  const TemporaryFolder folder;
  SlicePlan liver;
  liver.intercept = "0";
  liver.values = {9, 9, 9, 9, 9, 9, 0, 0, 0, 0, 0, 0};
  SlicePlan tumour = liver;
  tumour.series = "4.4";
  tumour.instance = "4.4.4";
  tumour.values = {0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0};
  writeSeries(folder / "tumour", tumour, {0, 3});
  writeSeries(folder / "liver", liver, {0, 3});
  const auto named = readNamedLabels(folder.path());
  EXPECT_EQ(named.value.names, (std::map<int, std::string>{{1, "liver"}, {2, "tumour"}}));
  EXPECT_THAT(std::vector<int>(named.value.map.voxels.begin(), named.value.map.voxels.begin() + 7),
              testing::ElementsAre(1, 1, 2, 2, 1, 1, 0));
}

}  // namespace falciform::test
