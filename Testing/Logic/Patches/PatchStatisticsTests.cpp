#include "Logic/Patches/PatchStatistics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using testing::HasSubstr;

/// A grid of 1 mm with two strips of label 1 and a block of label 3.
Surface stripes() {
  Surface s = test::grid(40, 40);
  s.patch.assign(static_cast<std::size_t>(s.size()), 0);
  for (Index i = 0; i < s.size(); ++i) {
    const double x = s.points(i, 0), y = s.points(i, 1);
    int& label = s.patch[static_cast<std::size_t>(i)];
    if (x > 4.5 && x < 35.5 && ((y > 9.5 && y < 12.5) || (y > 19.5 && y < 22.5))) label = 1;
    if (x > 9.5 && x < 14.5 && y > 29.5 && y < 32.5) label = 3;
  }
  s.patchNames[3] = "round ligament";
  return s;
}

TEST(PatchStatistics, CountsMeasuresAndNamesEveryLabel) {
  for (const bool cloud : {false, true}) {
    Surface s = stripes();
    if (cloud) s.triangles.resize(0, 3);
    const std::vector<PatchStatistics> rows = patchStatistics(s);
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].label, 1);
    EXPECT_EQ(rows[0].name, "falciform");
    EXPECT_EQ(rows[0].points, 31 * 6);
    EXPECT_EQ(rows[0].pieces, 2);  // 8 mm apart, points every 1 mm
    EXPECT_NEAR(rows[0].lengthMm, 30, 1e-9);
    EXPECT_NEAR(rows[0].widthMm, 12, 1e-9);
    EXPECT_NEAR((rows[0].centroid - Vector3d(20, 16, 0)).norm(), 0, 1e-9);
    EXPECT_EQ(rows[1].name, "round ligament");
    EXPECT_EQ(rows[1].pieces, 1);
    EXPECT_NEAR(rows[1].lengthMm, 4, 1e-9);
    EXPECT_NEAR(rows[1].widthMm, 2, 1e-9);
    // Each inner vertex of a grid of right triangles owns 2/3 to 4/3 mm^2, 1 mm^2 on average.
    if (cloud)
      EXPECT_EQ(rows[0].areaMm2, 0);
    else
      EXPECT_NEAR(rows[0].areaMm2, 31 * 6, 2);  // mm^2: alternate diagonals even out but for the ends
  }
}

TEST(PatchStatistics, DoNotChangeUnderARigidMotion) {
  const Surface s = stripes();
  const Isometry3d motion = test::randomMotion(4);
  const std::vector<PatchStatistics> still = patchStatistics(s),
                                     moved = patchStatistics(transformed(s, motion, "scanner"));
  for (std::size_t i = 0; i < still.size(); ++i) {
    EXPECT_NEAR(moved[i].lengthMm, still[i].lengthMm, 1e-9);
    EXPECT_NEAR(moved[i].widthMm, still[i].widthMm, 1e-9);
    EXPECT_NEAR(moved[i].areaMm2, still[i].areaMm2, 1e-9);
    EXPECT_EQ(moved[i].pieces, still[i].pieces);
    EXPECT_NEAR((moved[i].centroid - motion * still[i].centroid).norm(), 0, 1e-9);
  }
}

TEST(PatchStatistics, HandleASinglePointAndNothing) {
  Surface s = test::grid(4, 4);
  EXPECT_TRUE(patchStatistics(s).empty());
  s.patch.assign(static_cast<std::size_t>(s.size()), 0);
  s.patch[7] = 2;
  const std::vector<PatchStatistics> mesh = patchStatistics(s);
  s.triangles.resize(0, 3);
  const std::vector<PatchStatistics> cloud = patchStatistics(s);
  for (const auto& rows : {mesh, cloud}) {
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].pieces, 1);
    EXPECT_EQ(rows[0].lengthMm, 0);
    EXPECT_EQ(rows[0].widthMm, 0);
  }
}

TEST(PatchWarnings, SayWhatIsMissingInPlainWords) {
  const Surface bare = test::grid(10, 10), painted = stripes();
  ASSERT_EQ(patchWarnings(bare, bare).size(), 1U);
  EXPECT_THAT(patchWarnings(bare, bare)[0], HasSubstr("No patches are painted"));
  const std::vector<std::string> onOne = patchWarnings(painted, bare);
  ASSERT_EQ(onOne.size(), 3U);  // two labels on one side only, one of them of 15 points
  EXPECT_THAT(onOne[0], HasSubstr("'falciform' is painted only on the pre-operative surface"));
  EXPECT_THAT(onOne[1], HasSubstr("'round ligament' is painted only"));
  EXPECT_THAT(onOne[2], HasSubstr("only 15 points on the pre-operative surface"));
  EXPECT_EQ(patchWarnings(painted, painted).size(), 2U);  // the small one, on both sides
  EXPECT_THAT(patchWarnings(bare, painted)[0], HasSubstr("only on the scan"));
}

}  // namespace
}  // namespace falciform
