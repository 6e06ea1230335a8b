#include <gtest/gtest.h>

#include <algorithm>

#include "Logic/IO/VolumeFiles.h"
#include "Testing/Logic/IO/VolumeBytes.h"
#include "Testing/Support/RealData.h"

namespace falciform::test {

namespace {

double volumeMl(const LabelMap& map) {
  const auto voxels =
      std::count_if(map.voxels.begin(), map.voxels.end(), [](auto label) { return label > 0; });
  return static_cast<double>(voxels) * map.voxelVolume() / 1000;
}

}  // namespace

TEST(VolumeReal, SegmentsOfIrcad17HaveTheirKnownGridAndVolume) {
  FALCIFORM_NEEDS_DATA("ircad17/couinaud.nii.gz");
  const auto map = readLabelMap(realData() / "ircad17/couinaud.nii.gz");
  EXPECT_EQ(map.value.size, Vector3i(512, 512, 119));
  EXPECT_LT((map.value.spacing() - Vector3d(0.743, 0.743, 1.6)).norm(), 1e-6);  // float32 of the header
  // LAS: i runs to the left (+x of LPS), j to the front (-y), k upwards.
  EXPECT_LT((map.value.world({0, 0, 0}) - Vector3d(0, 379.673, 0)).norm(), 1e-3);
  EXPECT_LT((map.value.world({1, 1, 1}) - Vector3d(0.743, 379.673 - 0.743, 1.6)).norm(), 1e-3);
  EXPECT_NEAR(volumeMl(map.value), 1861, 18.6);  // 1 % of the volume that the case is published with
  EXPECT_EQ(*std::max_element(map.value.voxels.begin(), map.value.voxels.end()), 8)
      << "Couinaud has eight segments";
  EXPECT_TRUE(map.warnings.empty());
}

TEST(VolumeReal, VesselsStoredAsFloat64AreALabelMap) {
  FALCIFORM_NEEDS_DATA("ircad17/vessel.nii.gz");
  const auto map = readLabelMap(realData() / "ircad17/vessel.nii.gz");
  EXPECT_EQ(map.value.size, Vector3i(512, 512, 119));
  EXPECT_GT(volumeMl(map.value), 20);
  EXPECT_LT(volumeMl(map.value), 300);
}

TEST(VolumeReal, EveryPatientOfTheCohortHasALiverOfHumanSize) {
  FALCIFORM_NEEDS_DATA("cohort/couinaud");
  int patients = 0;
  for (const auto& entry : std::filesystem::directory_iterator(realData() / "cohort/couinaud")) {
    const auto map = readLabelMap(entry.path());
    EXPECT_GT(volumeMl(map.value), 700) << entry.path();  // ml; adult livers range from about 0.8 to 3 l
    EXPECT_LT(volumeMl(map.value), 3500) << entry.path();
    ++patients;
  }
  EXPECT_EQ(patients, 10);
}

TEST(VolumeReal, ManyOrganMapWithALongHeaderIsRead) {
  FALCIFORM_NEEDS_DATA("volumes/example_seg_fast_force_split.nii.gz");
  const auto map = readLabelMap(realData() / "volumes/example_seg_fast_force_split.nii.gz");
  const auto ct = readImage(realData() / "volumes/example_ct.nii.gz");
  EXPECT_EQ(map.value.size, ct.value.size);
  EXPECT_LT((map.value.worldFromIndex - ct.value.worldFromIndex).norm(), 1e-6)
      << "map and CT share one grid, mm";
  double sum = 0;
  int voxels = 0;
  for (std::size_t v = 0; v < map.value.voxels.size(); ++v)
    if (map.value.voxels[v] == 5) sum += static_cast<double>(ct.value.voxels[v]), ++voxels;
  ASSERT_GT(voxels, 0);
  EXPECT_GT(sum / voxels, 30) << "HU of a liver";
  EXPECT_LT(sum / voxels, 160) << "HU of a liver";
}

TEST(VolumeReal, CtStoredInLpsOrderStandsUpright) {
  FALCIFORM_NEEDS_DATA("volumes/ct_cropped.nii.gz");
  const auto ct = readImage(realData() / "volumes/ct_cropped.nii.gz");
  EXPECT_LT((ct.value.worldFromIndex.topLeftCorner<3, 3>() - 1.5 * Matrix3d::Identity()).norm(), 1e-6);
  EXPECT_LT((ct.value.world({0, 0, 0}) - Vector3d(-71.658203125, -255.658203125, 540.2000122070312)).norm(),
            1e-4);
}

}  // namespace falciform::test
