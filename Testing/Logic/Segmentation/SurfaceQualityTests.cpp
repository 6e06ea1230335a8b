#include "Logic/Segmentation/SurfaceQuality.h"

#include <gtest/gtest.h>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/Segmentation/StructureImport.h"
#include "Logic/Segmentation/SurfaceImport.h"

namespace falciform {
namespace {

constexpr double kVoxelMm = 2, kRadiusMm = 40;

/// A ball of 40 mm, 2 mm voxels, and two beads beside it as label 2.
LabelMap ballAndBeads() {
  LabelMap map;
  map.size = {60, 60, 60};
  map.worldFromIndex.diagonal().head<3>().setConstant(kVoxelMm);
  map.voxels.assign(60 * 60 * 60, 0);
  for (int k = 0; k < 60; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 60; ++i) {
        const Vector3d at = map.world(Vector3d(i, j, k));
        if ((at - Vector3d(60, 60, 60)).norm() < kRadiusMm) map.at(i, j, k) = 1;
        if ((at - Vector3d(12, 12, 60)).norm() < 7 || (at - Vector3d(108, 108, 60)).norm() < 7)
          map.at(i, j, k) = 2;
      }
  return map;
}

TEST(SurfaceQuality, ASmoothSurfaceLiesLessThanAQuarterOfAVoxelFromTheSteps) {
  SurfaceImportSettings settings;
  settings.labels = {1};
  const SurfaceImportResult made = importSurface(ballAndBeads(), settings);
  const SurfaceQuality& quality = made.quality;
  // Middles of faces across the sphere's normal lie up to half a voxel on either side, evenly: a quarter on
  // average; of slanting faces less.
  EXPECT_LT(quality.meanMm, kVoxelMm / 4);
  EXPECT_GT(quality.meanMm, kVoxelMm / 20);
  EXPECT_LT(quality.p95Mm, 0.75 * kVoxelMm);
  EXPECT_LT(quality.maxMm, 1.2 * kVoxelMm);
  EXPECT_LE(quality.p95Mm, quality.maxMm);
  EXPECT_EQ(quality.crossings, 0);
  EXPECT_DOUBLE_EQ(quality.meanEdgeMm, meanEdgeLength(made.surface));
}

TEST(SurfaceQuality, ASurfaceThatIsTooLargeIsAsFarAwayAsItIs) {
  const LabelMap map = ballAndBeads();
  SurfaceImportSettings settings;
  settings.labels = {1};
  Surface surface = importSurface(map, settings).surface;
  const Eigen::RowVector3d middle(60, 60, 60);
  surface.points = ((surface.points.rowwise() - middle) * (kRadiusMm + 5) / kRadiusMm).rowwise() + middle;
  std::vector<char> ball(65536, 0);
  ball[1] = 1;
  const SurfaceQuality quality = measureQuality(surface, cutOut(map, ball));
  EXPECT_NEAR(quality.meanMm, 5, 0.5);  // a quarter of a voxel
  EXPECT_NEAR(quality.maxMm, 5, kVoxelMm);
}

TEST(SurfaceQuality, CrossingsAreCounted) {
  const LabelMap map = ballAndBeads();
  SurfaceImportSettings settings;
  settings.labels = {1};
  Surface surface = importSurface(map, settings).surface;
  const Eigen::RowVector3d middle(60, 60, 60), out = surface.points.row(0) - middle;
  std::vector<char> ball(65536, 0);
  ball[1] = 1;
  const Mask mask = cutOut(map, ball);
  surface.points.row(0) = middle - 0.5 * out;
  EXPECT_EQ(measureQuality(surface, mask).crossings, 0) << "a spike inside crosses nothing";
  surface.points.row(0) = middle - 2 * out;
  EXPECT_GT(measureQuality(surface, mask).crossings, 0) << "one that leaves on the other side does";
}

TEST(StructureImport, AllPiecesOfALabelBecomeClosedSurfaces) {
  const Surface beads = structureSurface(ballAndBeads(), 2);
  const TopologyReport shape = inspectTopology(beads);
  EXPECT_TRUE(shape.closedManifold());
  EXPECT_EQ(shape.components, 2);
  const double bead = 4.0 / 3 * M_PI * 343;
  EXPECT_NEAR(signedVolume(beads), 2 * bead, 0.15 * 2 * bead);  // 2 mm voxels, lightly smoothed
  EXPECT_THROW((void)structureSurface(ballAndBeads(), 7), InputError);
}

}  // namespace
}  // namespace falciform
