#include <gmock/gmock.h>

#include "Logic/IO/VolumeFiles.h"
#include "Testing/Logic/IO/VolumeBytes.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {

namespace {

using ::testing::HasSubstr;

constexpr double kTextMm = 1e-9;  // decimal numbers of the header are kept as doubles

// Row a of TransformMatrix is the direction of index axis a: i runs along y, j along z, k along x.
const std::string kStart =
    "ObjectType = Image\nNDims = 3\nBinaryData = True\nTransformMatrix = 0 1 0 0 0 1 1 0 0\nOffset = 10 -20 "
    "30\n"
    "ElementSpacing = 2 3 4\nDimSize = 2 3 4\n";
const std::string kLocal = "ElementDataFile = LOCAL\n";

class VolumeMetaImage : public ::testing::Test {
 protected:
  Loaded<LabelMap> read(const std::string& header, const std::string& voxels = goldenVoxels<std::uint8_t>()) {
    return readLabelMap(writeBytes(folder / "golden.mha", header + voxels));
  }
  std::string refusal(const std::string& header) {
    return refusalOf([&] { (void)read(header); });
  }
  TemporaryFolder folder;
};

void expectGolden(const LabelMap& map) {
  EXPECT_TRUE(holdsGoldenVoxels(map));
  EXPECT_LT((map.world({0, 0, 0}) - Vector3d(10, -20, 30)).norm(), kTextMm);
  EXPECT_LT((map.world({1, 0, 0}) - Vector3d(10, -18, 30)).norm(), kTextMm);
  EXPECT_LT((map.world({0, 1, 0}) - Vector3d(10, -20, 33)).norm(), kTextMm);
  EXPECT_LT((map.world({0, 0, 1}) - Vector3d(14, -20, 30)).norm(), kTextMm);
}

}  // namespace

TEST_F(VolumeMetaImage, RowsOfTheTransformMatrixAreTheDirectionsOfTheAxes) {
  const auto map = read(kStart + "ElementType = MET_UCHAR\n" + kLocal);
  expectGolden(map.value);
  EXPECT_TRUE(map.warnings.empty());
}

TEST_F(VolumeMetaImage, EveryPackingAndByteOrderGivesTheSameVoxels) {
  const std::string uchar = kStart + "ElementType = MET_UCHAR\n";
  expectGolden(read(uchar + "CompressedData = True\nCompressedDataSize = 32\n" + kLocal, goldenZlib()).value);
  expectGolden(read(uchar + "CompressedData = True\n" + kLocal, goldenZlib()).value);
  expectGolden(read(kStart + "ElementType = MET_SHORT\nBinaryDataByteOrderMSB = True\n" + kLocal,
                    goldenVoxels<std::int16_t>(true))
                   .value);
  expectGolden(read(kStart + "ElementType = MET_DOUBLE\nElementByteOrderMSB = False\n" + kLocal,
                    goldenVoxels<double>())
                   .value);
  expectGolden(read(kStart + "ElementType = MET_LONG\n" + kLocal, goldenVoxels<std::int32_t>()).value);
  std::string text;
  for (int v = 1; v <= kGoldenVoxels; ++v) text += std::to_string(v) + " ";
  expectGolden(read(uchar + "BinaryData = False\n" + kLocal, text).value);
}

TEST_F(VolumeMetaImage, HeadersWithTheirVoxelsElsewhereAreRead) {
  const auto expectRead = [&](const std::string& extra, const std::string& before) {
    writeBytes(folder / "golden.raw", before + goldenVoxels<std::uint8_t>());
    expectGolden(readLabelMap(writeBytes(folder / "golden.mhd", kStart + "ElementType = MET_UCHAR\n" + extra +
                                                                    "ElementDataFile = golden.raw\n"))
                     .value);
  };
  expectRead("", "");
  expectRead("HeaderSize = 7\n", "1234567");
  expectRead("HeaderSize = -1\n", "any length");
}

TEST_F(VolumeMetaImage, OlderNamesOfTheFieldsAreHonoured) {
  for (const std::string origin : {"Position", "Origin", "Offset"})
    for (const std::string rows : {"Rotation", "Orientation", "TransformMatrix"})
      expectGolden(
          read(
              "NDims : 3\r\nDimSize : 2 3 4\r\n" + rows + " = 0 1 0 0 0 1 1 0 0\r\n" + origin +
              " = 10 -20 30\r\nElementSize = 2 3 4\r\nElementType = MET_UCHAR\r\nElementDataFile = LOCAL\r\n")
              .value);
}

TEST_F(VolumeMetaImage, WhatTheHeaderLeavesOpenIsWarnedOf) {
  const auto map = read("NDims = 3\nDimSize = 2 3 4\nElementType = MET_UCHAR\n" + kLocal);
  EXPECT_TRUE(warns(map.warnings, "ElementSpacing"));
  EXPECT_TRUE(warns(map.warnings, "Offset"));
  EXPECT_TRUE(warns(map.warnings, "TransformMatrix"));
}

TEST_F(VolumeMetaImage, RefusesWhatItCannotReadAndSaysWhy) {
  const std::string uchar = kStart + "ElementType = MET_UCHAR\n";
  EXPECT_THAT(refusal(uchar + "ElementNumberOfChannels = 3\n" + kLocal), HasSubstr("colours"));
  EXPECT_THAT(refusal(kStart + "ElementType = MET_UCHAR_ARRAY\n" + kLocal), HasSubstr("MET_UCHAR_ARRAY"));
  EXPECT_THAT(refusal(uchar), HasSubstr("ElementDataFile"));
  EXPECT_THAT(refusal(uchar + "ElementDataFile = LIST\n"), HasSubstr("several files"));
  EXPECT_THAT(refusal(uchar + "ElementDataFile = nowhere.raw\n"), HasSubstr("no such file"));
  EXPECT_THAT(refusal(uchar + "NDims = 2\n" + kLocal), HasSubstr("2 dimensions"));
  EXPECT_THAT(refusal(uchar + "NDims = 4\nDimSize = 2 3 4 9\n" + kLocal), HasSubstr("time series of 9"));
  EXPECT_THAT(refusal(uchar + "DimSize = 2 0 4\n" + kLocal), HasSubstr("2 x 0 x 4"));
  EXPECT_THAT(refusal(uchar + "DimSize = 200 300 400\n" + kLocal), HasSubstr("truncated"));
  EXPECT_THAT(refusal(uchar + "DimSize = two\n" + kLocal), HasSubstr("'two'"));
  EXPECT_THAT(refusal(uchar + "ElementSpacing = 1 0 1\n" + kLocal), HasSubstr("spacing"));
  EXPECT_THAT(refusal(uchar + "Offset = 0 0 inf\n" + kLocal), HasSubstr("not a number"));
  EXPECT_THAT(refusal(uchar + "TransformMatrix = 1 0 0 1 0 0 0 0 1\n" + kLocal), HasSubstr("singular"));
  EXPECT_THAT(refusal(uchar + "CompressedData = True\n" + kLocal), HasSubstr("damaged"));
  EXPECT_THAT(refusal(uchar + "ObjectType = Mesh\n" + kLocal), HasSubstr("Image"));
  EXPECT_THAT(refusal("hello\nworld\n"), HasSubstr("no MetaImage"));
}

}  // namespace falciform::test
