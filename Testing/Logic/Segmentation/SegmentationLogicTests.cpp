#include "Logic/Segmentation/SegmentationLogic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "Logic/Core/Errors.h"
#include "Logic/Segmentation/FrontPreview.h"
#include "Testing/Logic/Segmentation/PaintedCt.h"

namespace falciform {
namespace {

using test::paintedCt;

const Vector3d kMiddle(50, 50, 50);

/// A ball of 25 mm in fat, 2 x 2 x 2.5 mm voxels, in a case.
struct Segmenting : testing::Test {
  Case document;
  SegmentationLogic logic{document};

  void SetUp() override {
    document.setCt(
        std::make_shared<const Image>(paintedCt({50, 50, 40}, {2, 2, 2.5}, 10, 5, [](const Vector3d& at) {
          return (at - kMiddle).norm() < 25 ? 100.0 : -90.0;
        })));
    logic.settings.leastVolumeMl = 0;
  }
  [[nodiscard]] int labelAt(const Vector3d& mm) const {
    const LabelMap& map = *document.labels();
    const Vector3i at =
        (map.worldFromIndex.inverse() * mm.homogeneous()).head<3>().array().round().cast<int>();
    return map.at(at.x(), at.y(), at.z());
  }
  [[nodiscard]] double volumeMl() const {
    const auto inside = std::count_if(document.labels()->voxels.begin(), document.labels()->voxels.end(),
                                      [](std::uint16_t label) { return label > 0; });
    return static_cast<double>(inside) * document.labels()->voxelVolume() / 1000;
  }
  void stroke(LabelStroke kind, const std::vector<Vector3d>& way, int label = 1) {
    logic.beginStroke(kind, label);
    for (const Vector3d& at : way) logic.dab(at);
    logic.endStroke();
  }
  void segment(bool goOn = false) { logic.accept(logic.prepare(goOn, {})({})); }
};

double ballMl(double radius) { return 4.0 / 3 * std::numbers::pi * radius * radius * radius / 1000; }

TEST_F(Segmenting, SeedsAreAddedRemovedAndTakenBack) {
  logic.addSeed(kMiddle);
  logic.addSeed({60, 50, 50});
  EXPECT_NEAR(logic.huAt(kMiddle), 100, 50);  // five standard deviations of the noise
  EXPECT_THROW(logic.addSeed({500, 0, 0}), InputError);
  logic.removeSeed(0);
  ASSERT_EQ(logic.seeds().rows(), 1);
  EXPECT_EQ(logic.seeds()(0, 0), 60);
  logic.undo();
  ASSERT_EQ(logic.seeds().rows(), 2);
  logic.undo();
  EXPECT_EQ(logic.seeds().rows(), 1);
  logic.redo();
  logic.redo();
  ASSERT_EQ(logic.seeds().rows(), 1);
  EXPECT_EQ(logic.seeds()(0, 0), 60);
  logic.clearSeeds();
  EXPECT_EQ(logic.seeds().rows(), 0);
  EXPECT_FALSE(logic.missingInput().empty());
}

TEST_F(Segmenting, AStrokePaintsABallAlongItsWayAndUndoTakesIt) {
  logic.brushMm = 8;
  stroke(LabelStroke::Paint, {{30, 50, 50}, {70, 50, 50}}, 3);
  const double capsule = ballMl(8) + std::numbers::pi * 64 * 40 / 1000;
  EXPECT_NEAR(volumeMl(), capsule, 0.08 * capsule);  // dabs half a radius apart, voxels of 10 mm3
  EXPECT_EQ(labelAt({50, 50, 50}), 3) << "between the two reports of the mouse";
  EXPECT_EQ(labelAt({50, 60.5, 50}), 0);
  logic.undo();
  EXPECT_EQ(volumeMl(), 0);
  logic.redo();
  EXPECT_NEAR(volumeMl(), capsule, 0.08 * capsule);
}

TEST_F(Segmenting, ThreadsOfEventsWithoutAStrokeDoNothing) {
  logic.dab(kMiddle);
  logic.endStroke();
  EXPECT_FALSE(document.labels());
  stroke(LabelStroke::Paint, {{-500, 0, 0}});
  EXPECT_FALSE(document.labels()) << "outside of the grid";
  EXPECT_FALSE(logic.canUndo()) << "an empty stroke is no step";
}

TEST_F(Segmenting, GrowsMendsAndGoesOn) {
  logic.addSeed(kMiddle);
  segment();
  ASSERT_TRUE(logic.last());
  EXPECT_NEAR(volumeMl(), ballMl(25), 0.08 * ballMl(25));  // 7 % is a quarter of a voxel of the radius
  const double whole = volumeMl();

  // A bite out of it stays out when the front goes on; a painted knob outside stays in.
  logic.brushMm = 9;
  stroke(LabelStroke::Erase, {{70, 50, 50}});
  EXPECT_LT(volumeMl(), whole);
  stroke(LabelStroke::Paint, {{20, 50, 50}});
  segment(true);
  EXPECT_EQ(labelAt({70, 50, 50}), 0);
  EXPECT_EQ(labelAt({50, 70, 50}), 1);
  EXPECT_EQ(labelAt({20, 50, 50}), 1);
  // Without the erased voxels the same front takes the bite in again.
  stroke(LabelStroke::Paint, {{70, 50, 50}});
  EXPECT_EQ(logic.forbidden()->voxels, std::vector<std::uint16_t>(logic.forbidden()->voxels.size(), 0));
  segment(true);
  EXPECT_EQ(labelAt({70, 50, 50}), 1);
  // All the way back: two runs, three strokes, the first run, the seed.
  for (int step = 0; step < 7; ++step) logic.undo();
  EXPECT_FALSE(logic.canUndo());
  EXPECT_EQ(logic.seeds().rows(), 0);
}

TEST_F(Segmenting, GoingOnKeepsOtherLabels) {
  logic.addSeed(kMiddle);
  segment();
  logic.brushMm = 6;
  stroke(LabelStroke::Paint, {{55, 50, 50}}, 2);
  segment(true);
  EXPECT_EQ(labelAt({55, 50, 50}), 2);
  EXPECT_EQ(labelAt({40, 50, 50}), 1);
}

TEST_F(Segmenting, LabelsOfAnotherGridAreNotGoneOnFrom) {
  auto other = std::make_shared<LabelMap>();
  other->size = {5, 5, 5};
  other->voxels.assign(125, 1);
  logic.addSeed(kMiddle);
  segment();
  document.setLabels(other);
  EXPECT_THAT(logic.missingToContinue(), testing::HasSubstr("not on the CT's grid"));
  logic.undo();
  EXPECT_EQ(document.labels(), other) << "steps of the map that is gone are forgotten";
  EXPECT_EQ(logic.seeds().rows(), 0) << "the seed's is not";
}

TEST_F(Segmenting, AStoppedFrontIsKeptOnTheCtsGrid) {
  logic.addSeed(kMiddle);
  std::shared_ptr<const LabelMap> coarse;
  logic.settings.coarsestMm = 4;
  LevelSetResult whole = logic.prepare(false, [&](const Mask& front) {
    if (!coarse) coarse = std::make_shared<const LabelMap>(previewOf(front).labels);
  })({});
  ASSERT_TRUE(coarse);
  EXPECT_GT(coarse->voxelVolume(), 3 * whole.labels.voxelVolume());
  const LevelSetResult stopped = logic.prepareStopped(false, coarse)({});
  EXPECT_EQ(stopped.labels.size, document.ct()->size);
  EXPECT_GT(test::dice(stopped.labels, whole.labels), 0.9) << "voxels of 4 mm on a ball of 25";
  ASSERT_EQ(stopped.warnings.size(), 1u);
  EXPECT_THAT(stopped.warnings[0], testing::HasSubstr("stopped before the end"));
}

TEST(FrontPreview, SurfaceEnclosesWhatIsInside) {
  Mask front;
  front.size = {60, 60, 40};
  front.worldFromIndex.diagonal().head<3>() = Vector3d(1.5, 1.5, 2);
  front.voxels.assign(60 * 60 * 40, 0);
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 60; ++i)
        front.at(i, j, k) = (front.world(Vector3d(i, j, k)) - Vector3d(45, 45, 40)).norm() < 30;
  const FrontPreview preview = previewOf(front);
  ASSERT_GT(preview.surface.size(), 0);
  const Points from = preview.surface.points.rowwise() - Eigen::RowVector3d(45, 45, 40);
  EXPECT_NEAR(from.rowwise().norm().mean(), 30, 1) << "mm; blocks of 4";
  EXPECT_LT(preview.surface.size(), 3000) << "light";
  Image like;
  like.size = front.size;
  like.worldFromIndex = front.worldFromIndex;
  like.voxels.resize(front.voxels.size());
  EXPECT_EQ(onGridOf(like, preview.labels).voxels, preview.labels.voxels);
  EXPECT_EQ(previewOf(Mask{{4, 4, 4}, Matrix4d::Identity(), std::vector<std::uint8_t>(64, 0)}).surface.size(),
            0);
}

TEST(LabelBrush, IsTheBallOfABruteForceSearch) {
  LabelMap grid;
  grid.size = {20, 18, 16};
  grid.worldFromIndex << 1.2, 0.4, 0, 5, -0.4, 1.5, 0.3, 2, 0, -0.3, 2.5, -7, 0, 0, 0, 1;  // oblique
  grid.voxels.assign(20 * 18 * 16, 0);
  for (const Vector3d& index : {Vector3d(10, 9, 8), Vector3d(0.2, 3, 15), Vector3d(19, 17, 0.4)})
    for (const double radius : {0.1, 3.0, 7.5}) {
      const Vector3d place = grid.world(index);
      std::vector<std::size_t> expected;
      for (int k = 0; k < 16; ++k)
        for (int j = 0; j < 18; ++j)
          for (int i = 0; i < 20; ++i)
            if ((grid.world(Vector3d(i, j, k)) - place).norm() <= radius ||
                Vector3i(i, j, k) == Vector3i(index.array().round().cast<int>()))
              expected.push_back(grid.offset(i, j, k));
      EXPECT_EQ(voxelsInBall(grid, place, radius), expected) << radius;
    }
  EXPECT_TRUE(voxelsInBall(grid, grid.world({-3, 0, 0}), 5).empty());
}

}  // namespace
}  // namespace falciform
