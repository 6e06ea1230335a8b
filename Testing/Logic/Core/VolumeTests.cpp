#include "Logic/Core/Volume.h"

#include <gtest/gtest.h>

#include "Testing/Support/SmallSurfaces.h"

namespace falciform {

TEST(Volume, TheFirstIndexRunsFastest) {
  LabelMap map;
  map.size = {2, 3, 4};
  for (std::uint16_t v = 0; v < 24; ++v) map.voxels.push_back(v);
  std::size_t expected = 0;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 2; ++i, ++expected) {
        EXPECT_EQ(map.offset(i, j, k), expected);
        EXPECT_EQ(map.at(i, j, k), expected);
      }
}

TEST(Volume, SpacingAndVoxelVolumeDoNotDependOnOrientationOrHandedness) {
  const Vector3d spacing(0.7, 1.1, 2.5);
  for (const double sign : {1.0, -1.0}) {
    LabelMap map;
    map.worldFromIndex.topLeftCorner<3, 3>() =
        test::randomMotion(5).linear() * Vector3d(spacing.x(), spacing.y(), sign * spacing.z()).asDiagonal();
    map.worldFromIndex.topRightCorner<3, 1>() = Vector3d(1, 2, 3);
    EXPECT_LT((map.spacing() - spacing).norm(), 1e-14);  // mm, rounding
    EXPECT_NEAR(map.voxelVolume(), spacing.prod(), 1e-14);
    EXPECT_EQ(map.world({0, 0, 0}), Vector3d(1, 2, 3));
    EXPECT_NEAR((map.world({3, 5, 7}) - map.world({3, 5, 8})).norm(), 2.5, 1e-13);
  }
}

TEST(Volume, OffsetsOfLargeVolumesDoNotOverflow) {
  Image image;
  image.size = {2048, 2048, 2048};
  EXPECT_EQ(image.offset(2047, 2047, 2047), (std::size_t{1} << 33) - 1);
}

}  // namespace falciform
