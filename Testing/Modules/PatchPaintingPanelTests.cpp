#include <gmock/gmock.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QTableWidget>

#include "Logic/Acquisition/SyntheticLiver.h"
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
  auto& patches = child<QTableWidget>(panel, "patchTable");
  EXPECT_EQ(patches.item(0, 0)->text(), "falciform");
  EXPECT_EQ(patches.item(1, 0)->text(), "inferior ridge");
  patches.setCurrentCell(1, 0);
  EXPECT_EQ(bench.painting.label, patch::kInferiorRidge);
  child<QDoubleSpinBox>(panel, "brushRadius").setValue(12.5);
  EXPECT_DOUBLE_EQ(bench.painting.radiusMm, 12.5);
  click(panel, "brushErase");
  EXPECT_EQ(bench.painting.label, patch::kNone);
  EXPECT_EQ(patches.currentRow(), 1) << "the marked patch is remembered while erasing";
  click(panel, "brushReplace");
  EXPECT_EQ(bench.painting.label, patch::kInferiorRidge);
  EXPECT_TRUE(bench.painting.replaces);
  click(panel, "brushAdd");
  EXPECT_FALSE(bench.painting.replaces);
}

TEST_F(PatchPaintingPanelTest, ToolsSayHowTheyWorkAndShowWhatTheyNeed) {
  openBareSphere();
  const char* tools[]{"toolBrush", "toolLine", "toolLasso", "toolFill"};
  QStringList hints;
  for (int i = 0; i < 4; ++i) {
    click(panel, tools[i]);
    EXPECT_EQ(static_cast<int>(bench.painting.tool), i);
    EXPECT_EQ(isShown(panel, "pathSnap"), i == 1);
    hints << child<QLabel>(panel, "toolHint").text();
  }
  EXPECT_EQ(hints.removeDuplicates(), 0);
  EXPECT_FALSE(hints.contains(""));
}

TEST_F(PatchPaintingPanelTest, SnappingMeasuresTheSurfaceOnceAndItsCostsAreTheLines) {
  openPreopAndScan();
  click(panel, "toolLine");
  EXPECT_FALSE(bench.painting.pathCost());
  auto& snap = child<QComboBox>(panel, "pathSnap");
  snap.setCurrentIndex(1);
  Q_EMIT snap.activated(1);
  ASSERT_TRUE(bench.painting.pathCost()) << errors.join(" ").toStdString();
  const VectorXd cost = *bench.painting.pathCost();
  EXPECT_EQ(cost.size(), bench.document.preop()->size());
  EXPECT_LT(cost.minCoeff(), 0.9);
  (void)paintOnce();
  EXPECT_TRUE(bench.painting.pathCost()) << "painting does not change the shape";
  snap.setCurrentIndex(0);
  Q_EMIT snap.activated(0);
  EXPECT_FALSE(bench.painting.pathCost());
}

TEST_F(PatchPaintingPanelTest, EyeLockAndNameOfAPatchAreInItsRow) {
  openPreopAndScan();
  auto& table = child<QTableWidget>(panel, "patchTable");
  table.item(0, 0)->setCheckState(Qt::Unchecked);
  EXPECT_FALSE(bench.view.patchLook(patch::kFalciform).visible);
  EXPECT_NE(words(panel, "missing").find("hidden"), std::string::npos);
  table.item(0, 5)->setCheckState(Qt::Checked);
  EXPECT_EQ(bench.painting.locked(), std::set<int>{patch::kFalciform});
  EXPECT_FALSE(isEnabled(panel, "clearPatch"));
  EXPECT_FALSE(isEnabled(panel, "growPatch"));
  EXPECT_FALSE(table.item(0, 0)->flags() & Qt::ItemIsEditable) << "the two known patches keep their names";
  auto named = std::make_shared<Surface>(*bench.document.preop());
  named->patchNames[5] = "fossa";
  bench.document.setPreop(named);
  ASSERT_EQ(table.rowCount(), 3);
  table.item(2, 0)->setText("gallbladder fossa");
  EXPECT_EQ(bench.document.preop()->patchNames.at(5), "gallbladder fossa");
  EXPECT_EQ(bench.document.scan()->patchNames.at(5), "gallbladder fossa");
  EXPECT_TRUE(errors.isEmpty());
}

TEST_F(PatchPaintingPanelTest, OperationsOnAWholePatchAreOneStepEach) {
  openPreopAndScan();
  const auto before = bench.document.preop()->patch;
  child<QDoubleSpinBox>(panel, "patchStep").setValue(12);  // mm: more than the coarse body's edges
  for (const char* operation : {"growPatch", "shrinkPatch", "smoothPatch"}) {
    click(panel, operation);
    EXPECT_NE(bench.document.preop()->patch, before) << operation;
    click(panel, "undo");
    EXPECT_EQ(bench.document.preop()->patch, before) << operation;
  }
  for (const char* operation : {"fillHoles", "largestPiece"}) click(panel, operation);
  EXPECT_TRUE(errors.isEmpty());
}

TEST_F(PatchPaintingPanelTest, ASuggestionIsShownAcceptedAndTakenBackInOneStep) {
  EXPECT_FALSE(isEnabled(panel, "suggest"));
  SyntheticLiverSettings shape;
  shape.edgeLengthMm = 4;
  Surface liver = makeSyntheticLiver(shape).surface;
  const std::vector<int> truth = liver.patch;
  liver.patch.clear();
  bench.document.setPreop(std::make_shared<const Surface>(liver));
  click(panel, "suggest");
  auto& list = child<QComboBox>(panel, "suggestions");
  ASSERT_GT(list.count(), 0) << errors.join(" ").toStdString();
  ASSERT_TRUE(bench.view.options().suggestedLine) << "drawn before it is accepted";
  EXPECT_TRUE(patchLabels(*bench.document.preop()).empty());
  const int label = bench.view.options().suggestedLabel;
  click(panel, "acceptSuggestion");
  const std::vector<int> taken = pointsOfPatch(*bench.document.preop(), label);
  EXPECT_GT(taken.size(), 20u);
  int right = 0;
  for (const int id : taken) right += truth[static_cast<std::size_t>(id)] == label ? 1 : 0;
  EXPECT_GT(right, 0.2 * static_cast<double>(taken.size())) << "it lies on the feature";
  click(panel, "undo");
  EXPECT_TRUE(patchLabels(*bench.document.preop()).empty());
  panel.leave();
  EXPECT_FALSE(bench.view.options().suggestedLine);
}

TEST_F(PatchPaintingPanelTest, NamingAPatchKeepsTheUndo) {
  openBareSphere();
  ASSERT_FALSE(paintOnce().empty());
  auto named = std::make_shared<Surface>(*bench.document.preop());
  named->patchNames[3] = "fossa";
  bench.document.setPreop(named);
  EXPECT_TRUE(bench.painting.canUndo());
  (void)bench.painting.undo();
  EXPECT_EQ(bench.document.preop()->patchNames.at(3), "fossa");
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
  ASSERT_EQ(table.rowCount(), 2);
  EXPECT_EQ(table.item(0, 0)->text(), "falciform");
  EXPECT_EQ(table.item(0, 1)->text(), QString::number(stroke.ids.size()));
  EXPECT_EQ(table.item(0, 4)->text(), "1");

  click(panel, "undo");
  EXPECT_TRUE(patchLabels(*bench.document.preop()).empty());
  EXPECT_EQ(table.item(0, 1)->text(), "0");
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
