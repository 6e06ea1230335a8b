#include "Logic/VtkBridge/ImageBridge.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include "Logic/Core/Errors.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {

namespace {

LabelMap turned(double handedness) {
  LabelMap map;
  map.size = {3, 4, 5};
  map.worldFromIndex.topLeftCorner<3, 3>() =
      test::randomMotion(9).linear() * Vector3d(0.7, 1.3, handedness * 2.5).asDiagonal();
  map.worldFromIndex.topRightCorner<3, 1>() = Vector3d(-120, 80, -300);
  for (int v = 0; v < 60; ++v) map.voxels.push_back(static_cast<std::uint16_t>(1000 * v));
  return map;
}

}  // namespace

TEST(ImageBridge, EveryVoxelKeepsItsValueAndItsPlaceWhateverTheHandedness) {
  for (const double handedness : {1.0, -1.0}) {
    const LabelMap map = turned(handedness);
    const auto image = toVtk(map);
    for (int k = 0; k < 5; ++k)
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 3; ++i) {
          Vector3d world;
          image->TransformContinuousIndexToPhysicalPoint(i, j, k, world.data());
          EXPECT_LT((world - map.world(Vector3d(i, j, k))).norm(), 1e-10);  // mm, rounding at 300 mm
          EXPECT_EQ(image->GetScalarComponentAsDouble(i, j, k, 0), map.at(i, j, k));
        }
    EXPECT_GT(image->GetSpacing()[2], 0) << "a mirrored grid shows in the directions, not in the spacing";
    EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "Label");
  }
}

TEST(ImageBridge, IntensitiesStayFloat) {
  Image ct;
  ct.size = {2, 1, 1};
  ct.voxels = {-1024.5F, 3071.25F};
  const auto image = toVtk(ct);
  EXPECT_EQ(image->GetScalarType(), VTK_FLOAT);
  EXPECT_EQ(image->GetScalarComponentAsDouble(0, 0, 0, 0), -1024.5);
  EXPECT_EQ(image->GetScalarComponentAsDouble(1, 0, 0, 0), 3071.25);
}

TEST(ImageBridge, AShearOrAFlatAxisIsRefusedAndRoundingIsNot) {
  LabelMap map = turned(1);
  map.worldFromIndex.topLeftCorner<3, 3>() =
      map.worldFromIndex.topLeftCorner<3, 3>().cast<float>().cast<double>();
  EXPECT_NO_THROW((void)toVtk(map)) << "as a NIfTI header keeps it";
  map.worldFromIndex.block<3, 1>(0, 2) += 0.01 * map.worldFromIndex.block<3, 1>(0, 0);
  EXPECT_THROW((void)toVtk(map), InputError);
  map.worldFromIndex.block<3, 1>(0, 2).setZero();
  EXPECT_THROW((void)toVtk(map), InputError);
}

}  // namespace falciform
