#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Segmentation/SegmentationImportLogic.h"
#include "Logic/Segmentation/SurfaceImport.h"
#include "Testing/Logic/Segmentation/LabelMaps.h"

namespace falciform {
namespace {

using test::labelAt;
using testing::Contains;
using testing::HasSubstr;

double distance(const Vector3i& a, const Vector3i& b) { return (a - b).cast<double>().norm(); }

/// A ball of radius 14 voxels of 4 mm (736 ml) in a 40^3 grid, and what else `more` says.
LabelMap ball(const std::function<bool(const Vector3i&)>& more = [](const Vector3i&) { return false; }) {
  return labelAt({40, 40, 40}, 4, [&](const Vector3i& i) {
    return distance(i, {20, 20, 20}) < 14 || more(i);
  });
}

TEST(ImportCleaning, SmallPiecesAreDroppedAndReported) {
  const std::size_t whole = importSurface(ball(), {}).selectedVoxels;
  const LabelMap crumbs =
      ball([](const Vector3i& i) { return i.maxCoeff() <= 1 || i == Vector3i(37, 37, 37); });
  const SurfaceImportResult result = importSurface(crumbs, {});
  EXPECT_EQ(result.selectedVoxels, whole);
  EXPECT_EQ(result.droppedVoxels, 9u);
  EXPECT_EQ(result.topology.components, 1);
  EXPECT_THAT(result.warnings, Contains(HasSubstr("2 smaller pieces of 9 voxels (0.576 ml) dropped")));

  SurfaceImportSettings all;
  all.largestComponent = false;
  EXPECT_EQ(importSurface(crumbs, all).topology.components, 3);
  EXPECT_EQ(importSurface(crumbs, all).selectedVoxels, whole + 9);
}

TEST(ImportCleaning, PiecesThatTouchAtACornerOrEdgeAreApart) {
  const auto second = [](const Vector3i& shift) {
    return ball(
        [&](const Vector3i& i) { return (i - shift).minCoeff() >= 0 && (i - shift).maxCoeff() <= 1; });
  };
  // (20, 20, 34) is the ball's first background voxel on its axis; (21, 20, 34) touches the ball at edges
  // only.
  const LabelMap map = second({21, 20, 34});
  const SurfaceImportResult result = importSurface(map, {});
  EXPECT_TRUE(result.topology.closedManifold());
  EXPECT_EQ(result.topology.components, 1);
}

TEST(ImportCleaning, CavitiesAreFilledAndReported) {
  const std::size_t whole = importSurface(ball(), {}).selectedVoxels;
  LabelMap hollow = ball();
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 40; ++i)
        if (distance({i, j, k}, {20, 20, 20}) < 6 || distance({i, j, k}, {20, 29, 20}) < 2)
          hollow.at(i, j, k) = 0;
  const SurfaceImportResult filled = importSurface(hollow, {});
  EXPECT_EQ(filled.selectedVoxels, whole);
  EXPECT_GT(filled.filledVoxels, 800u);
  EXPECT_EQ(filled.topology.components, 1);
  EXPECT_THAT(filled.warnings, Contains(HasSubstr("filled")));

  SurfaceImportSettings keep;
  keep.fillCavities = false;
  const SurfaceImportResult shell = importSurface(hollow, keep);
  EXPECT_TRUE(shell.topology.closedManifold());
  EXPECT_EQ(shell.topology.components, 3) << "the inner walls are surfaces of their own";
  EXPECT_EQ(shell.selectedVoxels, whole - filled.filledVoxels);
  EXPECT_NEAR(shell.surfaceVolumeMm3 / shell.voxelVolumeMm3, 1, 0.01);
}

TEST(ImportCleaning, AnOrganAtTheBorderIsClosedAndWarnedOf) {
  const LabelMap cut = labelAt({30, 40, 40}, 4, [](const Vector3i& i) {
    return distance(i, {29, 20, 20}) < 14;
  });
  const SurfaceImportResult result = importSurface(cut, {});
  EXPECT_TRUE(result.topology.closedManifold());
  EXPECT_NEAR(result.surfaceVolumeMm3 / result.voxelVolumeMm3, 1, 0.01);
  EXPECT_THAT(result.warnings, Contains(HasSubstr("touches the border")));
  // A full map touches on all sides, and is a box of its voxels.
  const SurfaceImportResult full =
      importSurface(labelAt({20, 20, 20}, 5, [](const Vector3i&) { return true; }), {});
  EXPECT_NEAR(full.surfaceVolumeMm3, 1e6, 1e4);
  // One slice: flat, but still closed.
  SurfaceImportSettings raw;
  raw.smoothingIterations = 0;
  const LabelMap slice = labelAt({40, 40, 1}, 4, [](const Vector3i& i) {
    return distance(i, {20, 20, 0}) < 14;
  });
  EXPECT_TRUE(importSurface(slice, raw).topology.closedManifold());
}

TEST(ImportCleaning, PiecesDroppedAtTheBorderDoNotWarnOfTheBorder) {
  const SurfaceImportResult result =
      importSurface(ball([](const Vector3i& i) { return i.maxCoeff() == 0; }), {});
  EXPECT_THAT(result.warnings, testing::Not(Contains(HasSubstr("border"))));
}

TEST(ImportCleaning, WarnsOfVolumesThatAreNoLivers) {
  const LabelMap small = labelAt({20, 20, 20}, 2, [](const Vector3i& i) {
    return distance(i, {10, 10, 10}) < 8;
  });
  EXPECT_THAT(importSurface(small, {}).warnings, Contains(HasSubstr("is this a liver?")));
  EXPECT_THAT(importSurface(ball(), {}).warnings, testing::IsEmpty());
}

/// Voxels that meet only at edges and corners are where marching cubes is ambiguous.
TEST(ImportCleaning, VoxelsTouchingAtEdgesAndCornersGiveManifolds) {
  SurfaceImportSettings all;
  all.largestComponent = false;
  for (const int iterations : {0, 30})
    for (int pattern = 1; pattern < 256; ++pattern) {
      all.smoothingIterations = iterations;
      const LabelMap map = labelAt({2, 2, 2}, 20, [&](const Vector3i& i) {
        return (pattern >> (i.x() + 2 * i.y() + 4 * i.z()) & 1) != 0;
      });
      const SurfaceImportResult result = importSurface(map, all);
      EXPECT_TRUE(result.topology.closedManifold()) << pattern << ": " << describeTopology(result.topology);
      EXPECT_GT(result.surfaceVolumeMm3, 0);
    }
}

class RandomBlobs : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Densities, RandomBlobs, testing::Values(0.1, 0.3, 0.5, 0.7, 0.9));

TEST_P(RandomBlobs, AlwaysGiveClosedManifolds) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    std::bernoulli_distribution organ(GetParam());
    const LabelMap map = labelAt({14, 13, 12}, 10, [&](const Vector3i&) { return organ(random); });
    for (const bool clean : {true, false})
      for (const double edge : {0.0, 12.0}) {
        SurfaceImportSettings settings;
        settings.largestComponent = settings.fillCavities = clean;
        settings.edgeLengthMm = edge;
        SurfaceImportResult result;
        try {
          result = importSurface(map, settings);
        } catch (const InputError& error) {
          FAIL() << "seed " << seed << ", edge " << edge << ": " << error.what();
        }
        EXPECT_TRUE(result.topology.closedManifold());
        EXPECT_GT(result.surfaceVolumeMm3, 0);
        if (clean) {
          EXPECT_EQ(result.topology.components, 1);
        }
      }
  }
}

TEST(ImportRefusals, NameWhatIsWrong) {
  const auto message = [](const LabelMap& map) -> std::string {
    try {
      (void)importSurface(map, {});
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  const auto none = [](const Vector3i&) { return false; };
  const auto all = [](const Vector3i&) { return true; };
  EXPECT_THAT(message(labelAt({4, 4, 4}, 5, none)), HasSubstr("empty"));
  EXPECT_THAT(message(LabelMap{}), HasSubstr("0 x 0 x 0"));
  EXPECT_THAT(message(labelAt({20, 20, 20}, 0.004, all)), HasSubstr("metres"));
  EXPECT_THAT(message(labelAt({20, 20, 20}, 4000, all)), HasSubstr("micrometres"));
  LabelMap flat = labelAt({20, 20, 20}, 4, all);
  flat.worldFromIndex.col(1) = flat.worldFromIndex.col(0);
  EXPECT_THAT(message(flat), HasSubstr("degenerate"));
  flat.worldFromIndex.setConstant(std::nan(""));
  EXPECT_THAT(message(flat), HasSubstr("degenerate"));
  LabelMap torn = labelAt({20, 20, 20}, 4, all);
  torn.voxels.resize(50);
  EXPECT_THAT(message(torn), HasSubstr("holds 50 values"));
}

TEST(SegmentationImportLogic, TakesLabelsFromTheCaseAndGivesItTheSurface) {
  Case document;
  SegmentationImportLogic logic(document);
  EXPECT_FALSE(logic.missingInput().empty());
  EXPECT_THROW((void)logic.prepare(), InputError);
  document.setLabels(std::make_shared<LabelMap>(ball()));
  EXPECT_TRUE(logic.missingInput().empty());

  const auto job = logic.prepare();
  logic.settings.labels = {99};  // the job keeps the settings it was made with
  document.setLabels(nullptr);   // and its own snapshot of the map
  const SurfaceImportResult result = job({});
  EXPECT_EQ(document.preop(), nullptr);
  logic.accept(result);
  ASSERT_NE(document.preop(), nullptr);
  EXPECT_EQ(document.preop()->points, result.surface.points);
  EXPECT_EQ(logic.last().selectedVoxels, result.selectedVoxels);

  document.setLabels(std::make_shared<LabelMap>(ball()));
  EXPECT_THROW((void)logic.run(), InputError) << "label 99";
  logic.settings.labels.clear();
  const Surface& surface = logic.run();
  EXPECT_EQ(&surface, document.preop().get());
}

}  // namespace
}  // namespace falciform
