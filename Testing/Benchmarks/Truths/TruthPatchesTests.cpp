#include "Testing/Benchmarks/Truths/TruthPatches.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Logic/Core/Errors.h"
#include "Logic/Segmentation/SurfaceImport.h"

namespace falciform::bench {
namespace {

constexpr double kBorderMm = 40;  // of segment 4 and 3, across x
constexpr double kVoxelMm = 2;

/// A wedge of 100 mm along x, sharp in front and below, between a steep front and a flat underside 36 degrees
/// apart. The segments part at x = 40.
LabelMap wedge(std::uint16_t leftSegment) {
  LabelMap map;
  map.size = {60, 50, 50};
  map.worldFromIndex = Matrix4d::Identity();
  map.worldFromIndex.topLeftCorner<3, 3>() *= kVoxelMm;
  map.voxels.assign(static_cast<std::size_t>(map.size.prod()), 0);
  for (int k = 0; k < map.size.z(); ++k)
    for (int j = 0; j < map.size.y(); ++j)
      for (int i = 0; i < map.size.x(); ++i) {
        const Vector3d place = map.world(Vector3d(i, j, k));
        const Vector3d fromEdge = place - Vector3d(0, 10, 10);
        const bool inside = place.x() > 8 && place.x() < 108 && fromEdge.z() > 0.55 * fromEdge.y() - 1 &&
                            fromEdge.z() < 2.2 * fromEdge.y() && place.z() < 80 && place.y() < 80;
        if (inside) map.at(i, j, k) = place.x() < kBorderMm ? 4 : leftSegment;
      }
  return map;
}

Surface imported(const LabelMap& map) {
  SurfaceImportSettings settings;
  settings.edgeLengthMm = 1.5;
  Surface surface = importSurface(map, settings).surface;
  surface.normals.resize(0, 3);
  return surface;
}

TEST(TruthPatches, GrooveRunsAlongTheBorderInFrontAndTheMarginAlongTheSharpEdge) {
  const LabelMap map = wedge(3);
  const Surface liver = imported(map);
  const std::vector<int> patch = paintedBySegments(liver, map);
  int groove = 0, margin = 0;
  double length = 0;
  for (Index v = 0; v < liver.size(); ++v) {
    const Vector3d place = liver.points.row(v).transpose();
    if (patch[static_cast<std::size_t>(v)] == patch::kFalciform) {
      ++groove;
      // Half the strip's width, and where in a voxel of 2 mm the segment changes.
      EXPECT_NEAR(place.x(), kBorderMm, 4 + kVoxelMm);
      length = std::max(length, place.z());
    }
    if (patch[static_cast<std::size_t>(v)] == patch::kInferiorRidge) {
      ++margin;
      EXPECT_LT((place - Vector3d(place.x(), 10, 10)).norm(), 12) << place.transpose();
    }
  }
  EXPECT_GT(groove, 50);
  EXPECT_GT(margin, 200);
  EXPECT_GT(length, 60);  // mm: up the front to near the top at 80
}

TEST(TruthPatches, AMapWithoutTheBorderIsRefusedInWords) {
  const LabelMap map = wedge(4);
  try {
    static_cast<void>(paintedBySegments(imported(map), map));
    FAIL() << "there is no border";
  } catch (const InputError& refused) {
    EXPECT_THAT(refused.what(), ::testing::HasSubstr("no border of segment 4"));
  }
}

}  // namespace
}  // namespace falciform::bench
