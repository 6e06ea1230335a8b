#include <gmock/gmock.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QTableWidget>

#include "Logic/IO/SurfaceFiles.h"
#include "Modules/PatchPainting/PatchPaintingPanel.h"
#include "Testing/Modules/PanelFixture.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

struct PatchPaintingPanelTest : PanelTest {
  PatchPaintingPanel panel{bench};

  void openBareSphere() { bench.document.setPreop(std::make_shared<const Surface>(sphere(50, 4))); }

  /// A dab at vertex 0 with the brush as it is.
  PatchEdit paintOnce() {
    const Surface& surface = *bench.document.preop();
    int triangle = 0;
    while ((surface.triangles.row(triangle).array() != 0).all()) ++triangle;
    bench.painting.beginStroke();
    (void)bench.painting.dab(triangle, surface.points.row(0).transpose());
    PatchEdit edit = bench.painting.endStroke();
    bench.view.brushChanged.emit();
    return edit;
  }
};

TEST_F(PatchPaintingPanelTest, PaintingWaitsForASurfaceAndSaysSo) {
  EXPECT_FALSE(isEnabled(panel, "paint"));
  EXPECT_FALSE(words(panel, "missing").empty());
  openBareSphere();
  EXPECT_TRUE(isEnabled(panel, "paint"));
  click(panel, "paintOnScan");
  EXPECT_FALSE(isEnabled(panel, "paint")) << "there is no scan yet";
  EXPECT_EQ(bench.painting.target, PaintTarget::Scan);
}

TEST_F(PatchPaintingPanelTest, BrushControlsAreTheLogicsBrush) {
  openBareSphere();
  auto& patches = child<QComboBox>(panel, "brushPatch");
  EXPECT_EQ(patches.itemText(0), "falciform");
  EXPECT_EQ(patches.itemText(1), "inferior ridge");
  patches.setCurrentIndex(1);
  Q_EMIT patches.activated(1);
  EXPECT_EQ(bench.painting.label, patch::kInferiorRidge);
  child<QDoubleSpinBox>(panel, "brushRadius").setValue(12.5);
  EXPECT_DOUBLE_EQ(bench.painting.radiusMm, 12.5);
  click(panel, "brushErase");
  EXPECT_EQ(bench.painting.label, patch::kNone);
  click(panel, "brushAdd");
  EXPECT_EQ(bench.painting.label, patch::kInferiorRidge) << "the chosen patch is remembered while erasing";
}

TEST_F(PatchPaintingPanelTest, ControlsFollowABrushThatTheMouseResized) {
  openBareSphere();
  bench.painting.radiusMm = 7.2;
  bench.view.brushChanged.emit();
  EXPECT_DOUBLE_EQ(child<QDoubleSpinBox>(panel, "brushRadius").value(), 7.2);
}

TEST_F(PatchPaintingPanelTest, PaintModeIsTheViewsAndEndsWithTheModule) {
  openBareSphere();
  click(panel, "paint");
  EXPECT_TRUE(bench.view.options().painting);
  bench.view.edit([](ViewOptions& options) { options.painting = false; });  // Esc in the view
  EXPECT_FALSE(child<QPushButton>(panel, "paint").isChecked());
  click(panel, "paint");
  panel.leave();
  EXPECT_FALSE(bench.view.options().painting);
}

TEST_F(PatchPaintingPanelTest, TheChosenSurfaceAloneIsShown) {
  openPreopAndScan();
  click(panel, "paintOnScan");
  EXPECT_EQ(bench.view.options().arrangement, Arrangement::ScanOnly);
  click(panel, "paintOnPreop");
  EXPECT_EQ(bench.view.options().arrangement, Arrangement::PreopOnly);
}

TEST_F(PatchPaintingPanelTest, AStrokeIsListedCanBeUndoneAndRedone) {
  openBareSphere();
  EXPECT_FALSE(isEnabled(panel, "undo"));
  const PatchEdit stroke = paintOnce();
  ASSERT_FALSE(stroke.empty());
  auto& table = child<QTableWidget>(panel, "patchTable");
  ASSERT_EQ(table.rowCount(), 1);
  EXPECT_EQ(table.item(0, 0)->text(), "falciform");
  EXPECT_EQ(table.item(0, 1)->text(), QString::number(stroke.ids.size()));
  EXPECT_EQ(table.item(0, 4)->text(), "1");

  click(panel, "undo");
  EXPECT_TRUE(patchLabels(*bench.document.preop()).empty());
  EXPECT_EQ(table.rowCount(), 0);
  EXPECT_TRUE(isEnabled(panel, "redo"));
  click(panel, "redo");
  EXPECT_EQ(pointsOfPatch(*bench.document.preop(), patch::kFalciform).size(), stroke.ids.size());
}

TEST_F(PatchPaintingPanelTest, ClearingAPatchLeavesTheOthersAndCanBeUndone) {
  openPreopAndScan();
  const auto before = bench.document.preop()->patch;
  click(panel, "clearPatch");
  EXPECT_EQ(patchLabels(*bench.document.preop()), std::vector<int>{patch::kInferiorRidge});
  click(panel, "undo");
  EXPECT_EQ(bench.document.preop()->patch, before);
}

TEST_F(PatchPaintingPanelTest, TransferLaysThePatchesOfAPaintedFileOntoTheSurface) {
  const TemporaryFolder folder;
  Surface painted = sphere(50, 4);
  painted.patch.assign(static_cast<std::size_t>(painted.size()), patch::kNone);
  for (Index i = 0; i < painted.size(); ++i)
    if (painted.points(i, 2) > 40) painted.patch[static_cast<std::size_t>(i)] = patch::kFalciform;
  writeSurface(folder / "painted.vtp", painted, Overwrite::Refuse);
  openBareSphere();
  panel.transferFrom(QString::fromStdString((folder / "painted.vtp").string()));
  EXPECT_EQ(bench.document.preop()->patch, painted.patch) << errors.join(" ").toStdString();
}

TEST_F(PatchPaintingPanelTest, TransferFromAnUnpaintedFileIsRefusedInWords) {
  const TemporaryFolder folder;
  writeSurface(folder / "bare.vtp", sphere(50, 2), Overwrite::Refuse);
  openBareSphere();
  const auto before = bench.document.preop();
  panel.transferFrom(QString::fromStdString((folder / "bare.vtp").string()));
  EXPECT_EQ(bench.document.preop(), before);
  ASSERT_FALSE(errors.isEmpty());
  EXPECT_TRUE(errors.front().contains("no painted patch"));
}

TEST_F(PatchPaintingPanelTest, AHiddenSurfaceIsWarnedOf) {
  openBareSphere();
  PartLook look = bench.view.look(part::kPreop);
  look.visible = false;
  bench.view.setLook(part::kPreop, look);
  EXPECT_TRUE(isShown(panel, "missing"));
  EXPECT_NE(words(panel, "missing").find("hidden"), std::string::npos);
}

}  // namespace
}  // namespace falciform::test
