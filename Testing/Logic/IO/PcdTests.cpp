#include <gmock/gmock.h>

#include "Logic/IO/Lzf.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Logic/IO/ScanSamples.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform {
namespace {

using namespace test;
using testing::HasSubstr;

class Pcd : public testing::TestWithParam<const char*> {
 protected:
  TemporaryFolder folder;
};

TEST_P(Pcd, AnOrganisedCloudBecomesTheSheetItShows) {
  const Points sheet = tiltedSheet(6, 9);
  put(folder / "s.pcd", pcdOf(sheet, 6, 9, {}, GetParam()));
  const Surface scan = readSurface(folder / "s.pcd").value;
  ASSERT_EQ(scan.size(), 54);
  EXPECT_LT((scan.points - sheet).cwiseAbs().maxCoeff(), 1e-3);  // mm: floats, six digits as text
  EXPECT_EQ(scan.triangles.rows(), 2 * 5 * 8);
  EXPECT_EQ(facingShare(scan, Vector3d::Zero()), 1);
  EXPECT_EQ(scan.colours.row(2 * 9 + 5), (Colours(1, 3) << 2, 5, 7).finished());
  EXPECT_EQ(scan.frame, "scanner");
  const Vector3d normal = Vector3d(0.1, 0, -1).normalized();  // of z = 300 + 0.1 x, towards the camera
  for (Index i = 0; i < scan.size(); ++i) EXPECT_GT(scan.normals.row(i).dot(normal), 0.9999);
}

TEST_P(Pcd, MissingSamplesLeaveHoles) {
  put(folder / "s.pcd", pcdOf(tiltedSheet(6, 9), 6, 9, {22, 23}, GetParam()));
  const Surface scan = readSurface(folder / "s.pcd").value;
  EXPECT_EQ(scan.size(), 52);
  // Two neighbours inside: six cells lose something, four of them one triangle and two of them both.
  EXPECT_EQ(scan.triangles.rows(), 80 - 4 - 4);
}

TEST_P(Pcd, TruncationIsRefused) {
  const std::string bytes = pcdOf(tiltedSheet(6, 9), 6, 9, {}, GetParam());
  for (const std::size_t length : {bytes.size() - 30, bytes.size() / 2, std::size_t{180}}) {
    put(folder / "s.pcd", bytes.substr(0, length));
    EXPECT_NE(refusalOf([&] { (void)readSurface(folder / "s.pcd"); }), "no error") << length;
  }
}

INSTANTIATE_TEST_SUITE_P(Codings, Pcd, testing::Values("ascii", "binary", "binary_compressed"));

TEST(PcdHeaders, MoreSamplesThanBytesAreRefusedBeforeTheyAreAskedFor) {
  const TemporaryFolder folder;
  std::string bytes = pcdOf(tiltedSheet(2, 2), 2, 2, {}, "binary");
  bytes.replace(bytes.find("WIDTH 2"), 7, "WIDTH 2000000000");
  bytes.replace(bytes.find("POINTS 4"), 8, "POINTS 4000000000");
  put(folder / "s.pcd", bytes);
  EXPECT_THAT(refusalOf([&] { (void)readSurface(folder / "s.pcd"); }),
              HasSubstr("more points than its bytes"));
}

TEST(Lzf, CopiesMayOverlapThemselves) {
  // "ab", then 5 bytes from 2 back: "ababa" behind it. Code: (5 - 2) << 5, distance 2 - 1.
  const std::string packed{1, 'a', 'b', 3 << 5, 1};
  EXPECT_EQ(unpackLzf(packed, 7), "abababa");
  EXPECT_EQ(unpackLzf(packed, 6), std::nullopt);
  EXPECT_EQ(unpackLzf(std::string{3 << 5, 1}, 5), std::nullopt);  // nothing to copy from
  EXPECT_EQ(unpackLzf(packLzfLiterally(std::string(100, 'q')), 100), std::string(100, 'q'));
}

TEST(Lzf, LongCopiesTakeTheirLengthFromTheNextByte) {
  const std::string packed{0, 'z', static_cast<char>(7 << 5), 10, 0};
  EXPECT_EQ(unpackLzf(packed, 1 + 7 + 10 + 2), std::string(20, 'z'));
}

}  // namespace
}  // namespace falciform
