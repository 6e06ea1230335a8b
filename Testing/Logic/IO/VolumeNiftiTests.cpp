#include <gmock/gmock.h>

#include <limits>

#include "Logic/IO/VolumeFiles.h"
#include "Testing/Logic/IO/VolumeBytes.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {

namespace {

using ::testing::HasSubstr;

// NIfTI-1 keeps its geometry in float32: 24 bits of numbers below 512 mm.
constexpr double kFloatMm = 1e-4;

class VolumeNifti : public ::testing::Test {
 protected:
  std::filesystem::path golden(const NiftiBytes& header,
                               const std::string& voxels = goldenVoxels<std::uint8_t>()) {
    return writeBytes(folder / "golden.nii", header.header() + voxels);
  }
  std::string refusal(const NiftiBytes& header, const std::string& voxels = goldenVoxels<std::uint8_t>()) {
    return refusalOf([&] { (void)readLabelMap(golden(header, voxels)); });
  }
  TemporaryFolder folder;
};

const Eigen::Matrix<double, 3, 4> kOblique{{0, -2, 0.5, 10}, {1, 0, 0, -20}, {0, 0.25, 3, 30}};

void expectOblique(const LabelMap& map) {
  // LPS = (-R, -A, S) of kOblique, by hand.
  EXPECT_LT((map.world({0, 0, 0}) - Vector3d(-10, 20, 30)).norm(), kFloatMm);
  EXPECT_LT((map.world({1, 0, 0}) - Vector3d(-10, 19, 30)).norm(), kFloatMm);
  EXPECT_LT((map.world({0, 1, 0}) - Vector3d(-8, 20, 30.25)).norm(), kFloatMm);
  EXPECT_LT((map.world({0, 0, 1}) - Vector3d(-10.5, 20, 33)).norm(), kFloatMm);
}

}  // namespace

TEST_F(VolumeNifti, SformOfEitherByteOrderIsTurnedFromRasIntoLps) {
  for (const bool bigEndian : {false, true}) {
    const auto map = readLabelMap(
        golden(NiftiBytes(bigEndian).sform(kOblique).type(512, 16), goldenVoxels<std::uint16_t>(bigEndian)));
    EXPECT_TRUE(holdsGoldenVoxels(map.value));
    expectOblique(map.value);
  }
}

TEST_F(VolumeNifti, Version2IsReadInEitherByteOrder) {
  for (const bool bigEndian : {false, true}) {
    std::string header(544, '\0');
    const auto put = [&](std::size_t offset, const std::string& bytes) {
      header.replace(offset, bytes.size(), bytes);
    };
    put(0, bytesOfNumber<std::int32_t>(540, bigEndian));
    put(4, std::string("n+2\0\r\n\x1a\n", 8));
    put(12, bytesOfNumber<std::int16_t>(4, bigEndian));
    const int dim[] = {3, 2, 3, 4, 1, 1, 1, 1};
    for (std::size_t d = 0; d < 8; ++d) put(16 + 8 * d, bytesOfNumber<std::int64_t>(dim[d], bigEndian));
    put(168, bytesOfNumber<std::int64_t>(544, bigEndian));
    put(348, bytesOfNumber<std::int32_t>(1, bigEndian));
    for (std::size_t i = 0; i < 12; ++i)
      put(400 + 8 * i,
          bytesOfNumber<double>(kOblique(static_cast<Index>(i / 4), static_cast<Index>(i % 4)), bigEndian));
    put(500, bytesOfNumber<std::int32_t>(2, bigEndian));
    const auto map =
        readLabelMap(writeBytes(folder / "two.nii", header + goldenVoxels<std::int16_t>(bigEndian)));
    EXPECT_TRUE(holdsGoldenVoxels(map.value));
    expectOblique(map.value);
  }
}

TEST_F(VolumeNifti, QformWithNegativeQfacTurnsTheThirdAxisRound) {
  // A quarter turn about x takes j to +z and k to -y; qfac = -1 makes that +y (RAS).
  const double half = std::sqrt(0.5);
  for (const double qfac : {-1.0, 1.0}) {
    const auto map = readLabelMap(golden(NiftiBytes().qform(qfac, {half, 0, 0}, {5, 6, 7}, {2, 3, 4})));
    EXPECT_LT((map.value.world({0, 0, 0}) - Vector3d(-5, -6, 7)).norm(), kFloatMm);
    EXPECT_LT((map.value.world({1, 0, 0}) - Vector3d(-7, -6, 7)).norm(), kFloatMm);
    EXPECT_LT((map.value.world({0, 1, 0}) - Vector3d(-5, -6, 10)).norm(), kFloatMm);
    EXPECT_LT((map.value.world({0, 0, 1}) - Vector3d(-5, -6 + 4 * qfac, 7)).norm(), kFloatMm);
  }
}

TEST_F(VolumeNifti, HalfTurnInTheQformNeedsNoScalarPart) {
  // The header of the IRCAD maps: quaternion (0, 1, 0), qfac -1.
  const auto map =
      readLabelMap(golden(NiftiBytes().qform(-1, {0, 1, 0}, {0, -379.673, 0}, {0.743, 0.743, 1.6})));
  EXPECT_LT((map.value.world({1, 1, 1}) - Vector3d(0.743, 379.673 - 0.743, 1.6)).norm(), kFloatMm);
}

TEST_F(VolumeNifti, SformIsPreferredAndADifferentQformIsWarnedOf) {
  NiftiBytes header;
  header.sform(kOblique).qform(1, {0, 0, 0}, {0, 0, 0}, {1, 1, 1});
  const auto map = readLabelMap(golden(header));
  expectOblique(map.value);
  EXPECT_TRUE(warns(map.warnings, "sform and qform"));
}

TEST_F(VolumeNifti, SpacingAloneIsTakenWithAWarning) {
  NiftiBytes header;
  header.put<float>(80, 2).put<float>(84, 3).put<float>(88, 4);
  const auto map = readLabelMap(golden(header));
  EXPECT_TRUE(warns(map.warnings, "neither sform nor qform"));
  EXPECT_LT((map.value.world({1, 1, 1}) - Vector3d(-2, -3, 4)).norm(), kFloatMm);
}

TEST_F(VolumeNifti, UnitsOfTheHeaderBecomeMillimetres) {
  const std::pair<int, double> units[] = {{1, 1000.0}, {2, 1.0}, {3, 0.001}, {2 + 8, 1.0}};
  for (const auto& [code, mm] : units) {
    NiftiBytes header;
    header.sform(kOblique).put<std::uint8_t>(123, code);
    const auto map = readLabelMap(golden(header));
    EXPECT_NEAR(map.value.world({0, 0, 0}).z(), 30 * mm, kFloatMm * mm) << "unit code " << code;
    EXPECT_NEAR(map.value.spacing().y(), std::hypot(2, 0.25) * mm, kFloatMm * mm) << "unit code " << code;
  }
  NiftiBytes silent;
  silent.sform(kOblique).put<std::uint8_t>(123, 0);
  EXPECT_TRUE(warns(readLabelMap(golden(silent)).warnings, "unit of length"));
}

TEST_F(VolumeNifti, EveryNumberTypeGivesTheSameVoxels) {
  NiftiBytes header;
  header.sform(kOblique);
  const auto expectGolden = [&]<class Stored>(Stored, int code) {
    const auto file = golden(NiftiBytes(header).type(code, 8 * sizeof(Stored)), goldenVoxels<Stored>());
    EXPECT_TRUE(holdsGoldenVoxels(readLabelMap(file).value)) << "type code " << code;
    EXPECT_TRUE(holdsGoldenVoxels(readImage(file).value)) << "type code " << code;
  };
  expectGolden(std::uint8_t{}, 2);
  expectGolden(std::int8_t{}, 256);
  expectGolden(std::int16_t{}, 4);
  expectGolden(std::uint16_t{}, 512);
  expectGolden(std::int32_t{}, 8);
  expectGolden(std::uint32_t{}, 768);
  expectGolden(std::int64_t{}, 1024);
  expectGolden(std::uint64_t{}, 1280);
  expectGolden(float{}, 16);
  expectGolden(double{}, 64);
}

TEST_F(VolumeNifti, SlopeAndInterceptAreAppliedUnlessTheyMeanNone) {
  NiftiBytes header;
  header.sform(kOblique).put<float>(112, 2).put<float>(116, -1024);
  EXPECT_EQ(readImage(golden(header)).value.at(1, 0, 0), 2 * 2 - 1024);
  for (const double none : {0.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_TRUE(holdsGoldenVoxels(readImage(golden(header.put<float>(112, none))).value));
}

TEST_F(VolumeNifti, LabelsMustBeWholeNumbersInRange) {
  const auto withLast = [&](double last) {
    std::string voxels = goldenVoxels<double>();
    voxels.replace(8 * 23, 8, bytesOfNumber<double>(last, false));
    return voxels;
  };
  NiftiBytes header;
  header.sform(kOblique).type(64, 64);
  EXPECT_EQ(readLabelMap(golden(header, withLast(65535))).value.voxels.back(), 65535);
  for (const double bad : {0.5, -1.0, 65536.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THAT(refusal(header, withLast(bad)), HasSubstr("voxel (1, 2, 3)")) << bad;
  }
  EXPECT_TRUE(
      warns(readImage(golden(header, withLast(std::numeric_limits<double>::infinity()))).warnings, "finite"));
}

TEST_F(VolumeNifti, VoxelsBeginWhereTheHeaderSays) {
  NiftiBytes header;
  header.sform(kOblique).put<float>(108, 13168);
  EXPECT_TRUE(holdsGoldenVoxels(
      readLabelMap(golden(header, std::string(13168 - 352, 'x') + goldenVoxels<std::uint8_t>())).value));
}

TEST_F(VolumeNifti, RefusesWhatItCannotReadAndSaysWhy) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  NiftiBytes good;
  good.sform(kOblique);
  const auto changed = [&](auto change) {
    NiftiBytes header = good;
    change(header);
    return refusal(header);
  };
  EXPECT_THAT(changed([](auto& h) { h.template put<std::int16_t>(40, 4).template put<std::int16_t>(48, 7); }),
              HasSubstr("time series of 7"));
  EXPECT_THAT(changed([](auto& h) { h.template put<std::int16_t>(40, 5).template put<std::int16_t>(50, 3); }),
              HasSubstr("3 values a voxel"));
  EXPECT_THAT(changed([](auto& h) { h.template put<std::int16_t>(40, 2); }), HasSubstr("2 dimensions"));
  EXPECT_THAT(changed([](auto& h) { h.template put<std::int16_t>(42, 0); }), HasSubstr("0 x 3 x 4"));
  EXPECT_THAT(changed([](auto& h) { h.template put<std::int16_t>(44, -3); }), HasSubstr("2 x -3 x 4"));
  EXPECT_THAT(changed([](auto& h) {
                for (const std::size_t d : {42, 44, 46}) h.template put<std::int16_t>(d, 32767);
              }),
              HasSubstr("2^31"));
  EXPECT_THAT(changed([](auto& h) { h.template put<std::int16_t>(42, 3000); }), HasSubstr("truncated"));
  EXPECT_THAT(changed([](auto& h) { h.type(128, 24); }), HasSubstr("RGB"));
  EXPECT_THAT(changed([](auto& h) { h.type(32, 64); }), HasSubstr("complex"));
  EXPECT_THAT(changed([](auto& h) { h.type(7, 8); }), HasSubstr("code is 7"));
  EXPECT_THAT(changed([&](auto& h) { h.template put<float>(280, nan); }), HasSubstr("not a number"));
  EXPECT_THAT(changed([](auto& h) {
                h.sform(Eigen::Matrix<double, 3, 4>{{1, 1, 0, 0}, {1, 1, 0, 0}, {0, 0, 1, 0}});
              }),
              HasSubstr("singular"));
  EXPECT_THAT(changed([](auto& h) { h.template put<float>(292, 1e9); }), HasSubstr("mm from the origin"));
  EXPECT_THAT(changed([](auto& h) { h.template put<float>(108, 100); }), HasSubstr("vox_offset"));
  EXPECT_THAT(changed([](auto& h) { h.template put<std::uint8_t>(345, 'i'); }), HasSubstr(".hdr/.img"));
  EXPECT_THAT(changed([](auto& h) {
                h.template put<std::int16_t>(254, 0).qform(1, {1, 1, 0}, {0, 0, 0}, {1, 1, 1});
              }),
              HasSubstr("quaternion"));
  EXPECT_THAT(changed([](auto& h) {
                h.template put<std::int16_t>(254, 0).qform(1, {0, 0, 0}, {0, 0, 0}, {1, 0, 1});
              }),
              HasSubstr("pixdim[2]"));
  EXPECT_THAT(refusalOf([&] { (void)readLabelMap(writeBytes(folder / "short.nii", "short")); }),
              HasSubstr("too few"));
  EXPECT_THAT(refusalOf([&] { (void)readLabelMap(writeBytes(folder / "no.nii", std::string(600, 'a'))); }),
              HasSubstr("no NIfTI"));
  EXPECT_THAT(refusalOf([&] { (void)readLabelMap(folder / "absent.nii"); }), HasSubstr("no such file"));
  EXPECT_THAT(refusalOf([&] { (void)readLabelMap(folder.path()); }), HasSubstr("extension"));
}

}  // namespace falciform::test
