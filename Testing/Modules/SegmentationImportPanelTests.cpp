#include <gmock/gmock.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QTableWidget>

#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Modules/SegmentationImport/SegmentationImportPanel.h"
#include "Testing/Modules/PanelFixture.h"

namespace falciform::test {
namespace {

constexpr double kVoxelMm = 4, kRadiusMm = 50;

/// A ball of label 1, its right half of label 2.
std::shared_ptr<const LabelMap> twoHalves() {
  auto map = std::make_shared<LabelMap>();
  map->size = {32, 32, 32};
  map->worldFromIndex.diagonal().head<3>().setConstant(kVoxelMm);
  map->voxels.assign(32 * 32 * 32, 0);
  for (int k = 0; k < 32; ++k)
    for (int j = 0; j < 32; ++j)
      for (int i = 0; i < 32; ++i)
        if (kVoxelMm * (Vector3d(i, j, k) - Vector3d::Constant(15.5)).norm() < kRadiusMm)
          map->at(i, j, k) = i < 16 ? 1 : 2;
  return map;
}

struct SegmentationImportPanelTest : PanelTest {
  SegmentationImportPanel panel{bench};
  QTableWidget& table = child<QTableWidget>(panel, "labelTable");
};

TEST_F(SegmentationImportPanelTest, SaysWhatIsMissingInsteadOfADeadButton) {
  EXPECT_FALSE(isEnabled(panel, "import"));
  EXPECT_FALSE(words(panel, "missing").empty());
  EXPECT_TRUE(isShown(panel, "missing"));
  bench.document.setLabels(twoHalves());
  EXPECT_TRUE(isEnabled(panel, "import"));
  EXPECT_FALSE(isShown(panel, "missing"));
}

TEST_F(SegmentationImportPanelTest, ListsTheLabelsWithTheirVoxelCountsAllTicked) {
  bench.document.setLabels(twoHalves());
  ASSERT_EQ(table.rowCount(), 2);
  const auto counts = labelCounts(*bench.document.labels());
  for (int row = 0; row < 2; ++row) {
    EXPECT_EQ(table.item(row, 0)->text(), QString::number(row + 1));
    EXPECT_EQ(table.item(row, 0)->checkState(), Qt::Checked);
    const std::size_t voxels = counts[static_cast<std::size_t>(row)].second;
    EXPECT_EQ(table.item(row, 2)->toolTip(), QString("%L1 voxels").arg(voxels));
    const double ml = static_cast<double>(voxels) * std::pow(kVoxelMm, 3) / 1000;
    EXPECT_NEAR(table.item(row, 2)->text().toDouble(), ml, 0.051) << "one decimal is shown";
  }
}

TEST_F(SegmentationImportPanelTest, TicksAreTheLabelsOfTheSettings) {
  bench.document.setLabels(twoHalves());
  table.item(0, 0)->setCheckState(Qt::Unchecked);
  EXPECT_EQ(panel.logic().settings.labels, std::vector<int>{2});
  table.item(0, 0)->setCheckState(Qt::Checked);
  EXPECT_TRUE(panel.logic().settings.labels.empty()) << "all ticked is said by none";
}

TEST_F(SegmentationImportPanelTest, ImportPutsAClosedSurfaceOfTheTickedLabelsIntoTheCase) {
  bench.document.setLabels(twoHalves());
  child<QDoubleSpinBox>(panel, "edgeLengthMm").setValue(6);
  click(panel, "import");
  ASSERT_TRUE(bench.document.preop()) << errors.join(" ").toStdString();
  EXPECT_TRUE(inspectTopology(*bench.document.preop()).closedManifold());
  const double ball = 4.0 / 3 * M_PI * std::pow(kRadiusMm, 3);
  EXPECT_NEAR(signedVolume(*bench.document.preop()), ball,
              0.03 * ball);  // 4 mm voxels and 6 mm edges on a 50 mm ball

  table.item(0, 0)->setCheckState(Qt::Unchecked);
  click(panel, "import");
  EXPECT_NEAR(signedVolume(*bench.document.preop()), ball / 2, 0.05 * ball);
  EXPECT_NE(words(panel, "importResult").find("vertices"), std::string::npos);
  EXPECT_NE(words(panel, "importResult").find("closed manifold, 1 piece, genus 0"), std::string::npos);
  EXPECT_TRUE(errors.isEmpty());
}

TEST_F(SegmentationImportPanelTest, APreviewLeavesTheCaseAloneUntilItIsTakenOrASettingChanges) {
  bench.document.setLabels(twoHalves());
  auto& edge = child<QDoubleSpinBox>(panel, "edgeLengthMm");
  auto& quality = child<QTableWidget>(panel, "qualityTable");
  edge.setValue(8);
  panel.enter();
  click(panel, "previewSurface");
  EXPECT_FALSE(bench.document.preop());
  const auto shown = bench.view.options().previewSurface;
  ASSERT_TRUE(shown);
  EXPECT_GE(quality.rowCount(), 10);
  edge.setValue(7);
  EXPECT_FALSE(bench.view.options().previewSurface) << "it is no longer what these settings make";
  EXPECT_EQ(quality.rowCount(), 0);
  click(panel, "previewSurface");
  const auto second = bench.view.options().previewSurface;
  click(panel, "import");
  ASSERT_TRUE(bench.document.preop());
  EXPECT_EQ(bench.document.preop()->points, second->points);
  EXPECT_FALSE(bench.view.options().previewSurface);
  EXPECT_GE(quality.rowCount(), 10) << "the report stays";
  panel.leave();
}

TEST_F(SegmentationImportPanelTest, RolesBringLabelsInAsStructures) {
  bench.document.setLabels(twoHalves());
  child<QComboBox>(panel, "labelRole2").setCurrentIndex(2);
  EXPECT_EQ(panel.logic().structures.at(2), "tumour 2");
  table.item(1, 1)->setText("segment VIII");
  click(panel, "import");
  EXPECT_EQ(bench.document.structures().count("segment VIII"), 1u) << errors.join(" ").toStdString();
  child<QComboBox>(panel, "labelRole2").setCurrentIndex(0);
  EXPECT_TRUE(panel.logic().structures.empty());
}

TEST_F(SegmentationImportPanelTest, AnotherLabelMapForgetsTheTicksOfTheLast) {
  bench.document.setLabels(twoHalves());
  table.item(0, 0)->setCheckState(Qt::Unchecked);
  bench.document.setLabels(twoHalves());
  EXPECT_TRUE(panel.logic().settings.labels.empty());
  EXPECT_EQ(table.rowCount(), 2);
  bench.document.setLabels(nullptr);
  EXPECT_EQ(table.rowCount(), 0);
}

TEST_F(SegmentationImportPanelTest, AFailedImportLeavesTheCaseAsItWasAndSaysWhy) {
  auto empty = std::make_shared<LabelMap>(*twoHalves());
  std::fill(empty->voxels.begin(), empty->voxels.end(), std::uint16_t{0});
  bench.document.setLabels(empty);
  panel.logic().settings.labels = {9};
  click(panel, "import");
  EXPECT_FALSE(bench.document.preop());
  EXPECT_FALSE(errors.isEmpty());
}

}  // namespace
}  // namespace falciform::test
