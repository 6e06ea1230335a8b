#include <gmock/gmock.h>

#include "Logic/IO/VolumeFiles.h"
#include "Testing/Logic/IO/VolumeBytes.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {

namespace {

using ::testing::HasSubstr;

constexpr double kTextMm = 1e-9;  // decimal numbers of the header are kept as doubles

const std::string kStart = "NRRD0004\n# a comment\ntype: uchar\ndimension: 3\nsizes: 2 3 4\n";
const std::string kLps =
    "space: left-posterior-superior\nspace directions: (0,2,0) (0.5,0,0) (0,0,-3)\nspace origin: "
    "(10,-20,30)\n";

class VolumeNrrd : public ::testing::Test {
 protected:
  Loaded<LabelMap> read(const std::string& header, const std::string& voxels = goldenVoxels<std::uint8_t>(),
                        const std::string& name = "golden.nrrd") {
    return readLabelMap(writeBytes(folder / name, header + "\n" + voxels));
  }
  std::string refusal(const std::string& header) {
    return refusalOf([&] { (void)read(header); });
  }
  TemporaryFolder folder;
};

}  // namespace

TEST_F(VolumeNrrd, PermutedAxesKeepTheirDirections) {
  const auto map = read(kStart + kLps + "encoding: raw\n");
  EXPECT_TRUE(holdsGoldenVoxels(map.value));
  EXPECT_TRUE(map.warnings.empty());
  EXPECT_LT((map.value.world({1, 1, 1}) - Vector3d(10.5, -18, 27)).norm(), kTextMm);
  EXPECT_LT((map.value.spacing() - Vector3d(2, 0.5, 3)).norm(), kTextMm);
}

TEST_F(VolumeNrrd, EverySpaceIsTurnedIntoLps) {
  const std::pair<std::string, Vector3d> spaces[] = {{"LPS", {1, 1, 1}},
                                                     {"right-anterior-superior", {-1, -1, 1}},
                                                     {"RAS", {-1, -1, 1}},
                                                     {"left-anterior-superior", {1, -1, 1}},
                                                     {"las", {1, -1, 1}}};
  for (const auto& [name, signs] : spaces) {
    const auto map =
        read(kStart + "space: " + name +
             "\nspace directions: (1,2,0) (-2,1,0) (0,0,3)\nspace origin: (10,20,30)\nencoding: raw\n");
    EXPECT_LT((map.value.world({1, 1, 1}) - signs.cwiseProduct(Vector3d(9, 23, 33))).norm(), kTextMm) << name;
    EXPECT_TRUE(map.warnings.empty()) << name;
  }
}

TEST_F(VolumeNrrd, AnUnnamedSpaceIsTakenAsLpsWithAWarning) {
  for (const std::string space : {"space dimension: 3", "space: scanner-xyz", "space: 3D-right-handed"}) {
    const auto map =
        read(kStart + space +
             "\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (1,2,3)\nencoding: raw\n");
    EXPECT_LT((map.value.world({0, 0, 0}) - Vector3d(1, 2, 3)).norm(), kTextMm);
    EXPECT_TRUE(warns(map.warnings, "LPS assumed")) << space;
  }
}

TEST_F(VolumeNrrd, SpacingsAloneAreTakenWithAWarning) {
  const auto map = read(kStart + "spacings: 2 3 4\nunits: \"um\" \"mm\" \"cm\"\nencoding: raw\n");
  EXPECT_TRUE(warns(map.warnings, "no orientation"));
  EXPECT_LT((map.value.world({1, 1, 1}) - Vector3d(0.002, 3, 40)).norm(), kTextMm);
}

TEST_F(VolumeNrrd, SpaceUnitsBecomeMillimetres) {
  const auto map = read(kStart + kLps + "space units: \"m\" \"um\" \"mm\"\nencoding: raw\n");
  EXPECT_LT((map.value.world({1, 1, 1}) - Vector3d(10500, -0.018, 27)).norm(), kTextMm);
}

TEST_F(VolumeNrrd, EveryEncodingAndByteOrderGivesTheSameVoxels) {
  EXPECT_TRUE(holdsGoldenVoxels(read(kStart + kLps + "encoding: gzip\n", goldenGzip()).value));
  std::string text;
  for (int v = 1; v <= kGoldenVoxels; ++v) text += std::to_string(v) + (v % 5 ? " " : "\n");
  EXPECT_TRUE(holdsGoldenVoxels(read(kStart + kLps + "encoding: ascii\n", text).value));
  for (const bool big : {false, true}) {
    const std::string header =
        std::string(
            "NRRD0005\r\nTYPE: unsigned short\r\ndimension: 3\r\nsizes: 2 3 4\r\nencoding: raw\r\nendian: ") +
        (big ? "big" : "little") + "\r\nspacings: 1 1 1\r\n\r";
    EXPECT_TRUE(holdsGoldenVoxels(read(header, goldenVoxels<std::uint16_t>(big)).value));
  }
}

TEST_F(VolumeNrrd, DetachedHeadersFindTheirVoxels) {
  const std::string header = kStart + kLps + "encoding: raw\ndata file: voxels.bin\n";
  const auto expectGolden = [&](const std::string& extra, const std::string& before,
                                const std::string& after) {
    writeBytes(folder / "voxels.bin", before + goldenVoxels<std::uint8_t>() + after);
    EXPECT_TRUE(holdsGoldenVoxels(readLabelMap(writeBytes(folder / "golden.nhdr", header + extra)).value))
        << extra;
  };
  expectGolden("", "", "");
  expectGolden("byte skip: 5\n", "12345", "");
  expectGolden("line skip: 2\n", "one\ntwo\n", "");
  expectGolden("lineskip: 1\nbyteskip: 2\n", "one\n12", "");
  expectGolden("byte skip: -1\n", "anything", "");
  std::filesystem::remove(folder / "voxels.bin");
  EXPECT_THAT(refusalOf([&] { (void)readLabelMap(folder / "golden.nhdr"); }),
              HasSubstr("voxels.bin': there is no such file"));
}

TEST_F(VolumeNrrd, SegmentationsOfOneLayerAreReadWithTheirNames) {
  const std::string keys =
      "Segment0_ID:=a\nSegment0_LabelValue:=3\nSegment0_Layer:=0\nSegment0_Name:=right lobe: S5, "
      "S6\nSegment1_LabelValue:=7\nSegment1_Layer:=0\n"
      "Segment1_Name:=tumour\nSegmentation_ReferenceImageExtentOffset:=11 12 13\n";
  const auto plain =
      read(kStart + kLps + "encoding: raw\n" + keys, goldenVoxels<std::uint8_t>(), "a.seg.nrrd");
  EXPECT_TRUE(holdsGoldenVoxels(plain.value));
  EXPECT_LT((plain.value.world({0, 0, 0}) - Vector3d(10, -20, 30)).norm(), kTextMm)
      << "the extent offset moves nothing";
  EXPECT_EQ(readLabelNames(folder / "a.seg.nrrd"),
            (std::map<int, std::string>{{3, "right lobe: S5, S6"}, {7, "tumour"}}));

  const auto listed = [&](int layers) {
    return "NRRD0004\ntype: uchar\ndimension: 4\nsizes: " + std::to_string(layers) +
           " 2 3 4\nspace: left-posterior-superior\nspace directions: none (0,2,0) (0.5,0,0) "
           "(0,0,-3)\nkinds: list domain domain domain\n"
           "space origin: (10,-20,30)\nencoding: raw\n" +
           keys;
  };
  EXPECT_TRUE(holdsGoldenVoxels(read(listed(1)).value));
  EXPECT_THAT(refusal(listed(2)), HasSubstr("2 layers"));
}

TEST_F(VolumeNrrd, RefusesWhatItCannotReadAndSaysWhy) {
  const std::string raw = "encoding: raw\n";
  const std::string four = "NRRD0004\ntype: uchar\ndimension: 4\nspace: LPS\nencoding: raw\n";
  EXPECT_THAT(refusal(four + "sizes: 3 2 3 4\nkinds: RGB-color domain domain domain\nspace directions: none "
                             "(1,0,0) (0,1,0) (0,0,1)\n"),
              HasSubstr("colours"));
  EXPECT_THAT(refusal(four + "sizes: 2 3 4 5\nkinds: domain domain domain time\nspace directions: (1,0,0) "
                             "(0,1,0) (0,0,1) none\n"),
              HasSubstr("time series of 5"));
  EXPECT_THAT(
      refusal(four +
              "sizes: 2 3 4 5\nspace: RAST\nspace directions: (1,0,0,0) (0,1,0,0) (0,0,1,0) (0,0,0,1)\n"),
      HasSubstr("time series"));
  EXPECT_THAT(refusal(kStart + "space: upside-down\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n" + raw),
              HasSubstr("upside-down"));
  EXPECT_THAT(refusal(kStart + kLps + "encoding: bzip2\n"), HasSubstr("bzip2"));
  EXPECT_THAT(refusal(kStart + kLps), HasSubstr("no 'encoding'"));
  EXPECT_THAT(refusal(kStart + kLps + raw + "data file: slice%03d.raw 1 4 1\n"), HasSubstr("several files"));
  EXPECT_THAT(refusal(kStart + kLps + raw + "type: block\n"), HasSubstr("'block'"));
  EXPECT_THAT(refusal(kStart + kLps + raw + "type: short\n"), HasSubstr("no 'endian'"));
  EXPECT_THAT(refusal(kStart + kLps + raw + "sizes: 2 3\n"), HasSubstr("'2 3'"));
  EXPECT_THAT(refusal(kStart + kLps + raw + "sizes: 2 -3 4\n"), HasSubstr("2 x -3 x 4"));
  EXPECT_THAT(refusal(kStart + kLps + raw + "sizes: 99999999999 99999999999 99999999999\n"),
              HasSubstr("2^31"));
  EXPECT_THAT(refusal(kStart + kLps + raw + "sizes: 2000 2000 400\n"), HasSubstr("truncated"));
  EXPECT_THAT(refusal(kStart + kLps + raw + "space origin: (0,nan,0)\n"), HasSubstr("not a number"));
  EXPECT_THAT(refusal(kStart + kLps + raw + "space directions: (1,0,0) (2,0,0) (0,0,1)\n"),
              HasSubstr("singular"));
  EXPECT_THAT(refusal(kStart + kLps + raw + "space directions: (1,0,0) (0,0,0) (0,0,1)\n"),
              HasSubstr("spacing"));
  EXPECT_THAT(refusal(kStart + kLps + raw + "space directions: (1,0,0) (0,1,0)\n"),
              HasSubstr("2 space directions for 3 axes"));
  EXPECT_THAT(refusal(kStart + kLps + raw + "space directions: oblique\n"), HasSubstr("'oblique'"));
  EXPECT_THAT(refusal(kStart + kLps + raw + "byte skip: -7\n"), HasSubstr("-7"));
  EXPECT_THAT(refusal(kStart + kLps + raw + "nonsense\n"), HasSubstr("'nonsense'"));
  EXPECT_THAT(refusal("P5\n"), HasSubstr("no NRRD"));
}

TEST_F(VolumeNrrd, DamagedCompressionIsRefused) {
  const std::string header = kStart + kLps + "encoding: gzip\n";
  std::string wrongSum = goldenGzip(), cut = goldenGzip().substr(0, 40), garbled = goldenGzip();
  wrongSum[37] = static_cast<char>(wrongSum[37] ^ 1);
  garbled[10] = '\x07';
  EXPECT_THAT(refusalOf([&] { (void)read(header, wrongSum); }), HasSubstr("damaged"));
  EXPECT_THAT(refusalOf([&] { (void)read(header, cut); }), HasSubstr("truncated"));
  EXPECT_THAT(refusalOf([&] { (void)read(header, garbled); }), HasSubstr("damaged"));
  EXPECT_TRUE(holdsGoldenVoxels(read(header, goldenGzip() + std::string(100, '\0')).value))
      << "padding is no data";
}

}  // namespace falciform::test
