#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QMouseEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QSlider>
#include <QTableWidget>
#include <QtTest/QTest>
#include <cstdio>
#include <functional>

#include "Modules/Application/Appearance.h"
#include "Modules/Application/MainWindow.h"
#include "Modules/DeformationAnalysis/ComparedCases.h"
#include "Modules/DeformationAnalysis/DeformationAnalysisPanel.h"
#include "Modules/ModuleList.h"
#include "Modules/ModulePanel.h"
#include "Modules/Workbench.h"
#include "Testing/Support/TemporaryFolder.h"
#include "Widgets/Views/CaseView3D.h"
#include "Widgets/Views/SliceView.h"

namespace {

using namespace falciform;

void waitIdle(Workbench& bench) {
  do QTest::qWait(300);
  while (bench.runner.busy());
  QTest::qWait(300);
}

void press(MainWindow& window, const char* button) {
  auto* found = window.currentPanel()->findChild<QAbstractButton*>(button);
  if (found && found->isEnabled()) found->click();
}

/// Scrolls the panel so that `name` stands at its top.
void scrollTo(MainWindow& window, const char* name) {
  auto* found = window.currentPanel()->findChild<QWidget*>(name);
  for (QWidget* parent = found; parent; parent = parent->parentWidget())
    if (auto* scroll = qobject_cast<QScrollArea*>(parent))
      scroll->verticalScrollBar()->setValue(found->mapTo(scroll->widget(), QPoint(0, 0)).y() - 6);
  QTest::qWait(100);
}

/// Seeds clicked in the CT, the front on its way, what came of it, mended, and the surface before it is
/// taken.
void importPictures(MainWindow& window, Workbench& bench, const std::function<void(const QString&)>& save,
                    const std::function<void(const QString&)>& saveNow) {
  auto* axial = window.findChild<SliceView*>("sliceAxial");
  if (!axial) return;
  save("SegmentationImport_opened");
  press(window, "addSeed");
  const std::vector<Vector3d> seeds{{-103, -23, -29}, {11, -45, 10}, {39, -17, 33}};
  for (const Vector3d& seed : seeds) {
    bench.view.wanderTo.emit(seed);
    QTest::mouseClick(axial, Qt::LeftButton, {}, axial->positionOf(seed).toPoint());
    QTest::qWait(50);
  }
  scrollTo(window, "segmentation");
  save("SegmentationImport_seeds");
  press(window, "segment");
  while (bench.runner.busy() && !bench.view.options().previewSurface) QTest::qWait(5);
  QTest::qWait(30);
  saveNow("SegmentationImport_front");
  waitIdle(bench);
  save("SegmentationImport_segmented");
  press(window, "eraseLabel");
  const QPoint from = axial->positionOf({60, -40, 33}).toPoint();
  QTest::mousePress(axial, Qt::LeftButton, {}, from);
  for (int i = 0; i <= 8; ++i) {
    const QPoint at = from + QPoint(0, 5 * i);
    QMouseEvent move(QEvent::MouseMove, at, axial->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QApplication::sendEvent(axial, &move);
  }
  QTest::mouseRelease(axial, Qt::LeftButton, {}, from + QPoint(0, 40));
  save("SegmentationImport_mended");
  press(window, "undoSegmentation");
  press(window, "eraseLabel");  // off again
  press(window, "previewSurface");
  waitIdle(bench);
  scrollTo(window, "labelTable");
  save("SegmentationImport_preview");
}

/// What the registration panel shows beside its result: figures further down, a replay, other poses, handles.
void registrationPictures(MainWindow& window, Workbench& bench,
                          const std::function<void(const QString&)>& save) {
  scrollTo(window, "beforeAfter");
  save("Registration_result");
  auto* slider = window.currentPanel()->findChild<QSlider*>("replayIteration");
  scrollTo(window, "register");
  if (slider) slider->setValue(slider->maximum() / 3);
  save("Registration_replay");
  press(window, "showBefore");
  save("Registration_at_start");
  press(window, "showAfter");
  auto* method = window.currentPanel()->findChild<QComboBox*>("method");
  method->setCurrentText("auto");
  press(window, "register");
  waitIdle(bench);
  if (auto* basins = window.currentPanel()->findChild<QTableWidget*>("basins")) basins->selectRow(1);
  scrollTo(window, "basinGroup");
  save("Registration_poses");
  press(window, "backToBest");
  waitIdle(bench);
  method->setCurrentText("picp");
  press(window, "register");
  waitIdle(bench);
  press(window, "startFromLandmarks");
  press(window, "moveByHand");
  for (const char* step : {"turnZPlus", "turnZPlus", "turnZPlus", "shiftXPlus", "shiftXPlus"})
    press(window, step);
  scrollTo(window, "purpose");
  save("Registration_by_hand");
  press(window, "resetHandPose");
  press(window, "startFromLandmarks");
}

/// Takes an item of a drop-down list as a person does.
void take(MainWindow& window, const char* box, int item) {
  if (auto* found = window.currentPanel()->findChild<QComboBox*>(box)) {
    found->setCurrentIndex(item);
    Q_EMIT found->activated(item);
  }
}

/// The ridge laid as a line from click to click, snapped to the edge, before and after it is painted.
void paintingPictures(MainWindow& window, Workbench& bench, const std::function<void(const QString&)>& save) {
  const auto liver = bench.document.preop();
  if (!liver) return;
  std::vector<Vector3d> ridge;
  for (const int id : pointsOfPatch(*liver, patch::kInferiorRidge))
    ridge.emplace_back(liver->points.row(id).transpose());
  if (ridge.size() < 50) return;
  std::sort(ridge.begin(), ridge.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
  bench.painting.label = patch::kInferiorRidge;
  bench.painting.radiusMm = 4;
  bench.view.brushChanged.emit();
  press(window, "clearPatch");
  press(window, "toolLine");
  take(window, "pathSnap", 1);
  waitIdle(bench);
  press(window, "paint");
  QTest::qWait(300);
  QWidget* canvas = window.view()->canvas();
  for (const double share : {0.04, 0.3, 0.55, 0.8}) {
    const QPoint at = window.view()->canvasPosition(
        ridge[static_cast<std::size_t>(share * static_cast<double>(ridge.size()))]);
    QTest::mouseMove(canvas, at);
    QTest::mouseClick(canvas, Qt::LeftButton, {}, at);
    QTest::qWait(300);
  }
  scrollTo(window, "patchTable");
  save("PatchPainting_line");
  canvas->setFocus();
  QTest::keyClick(canvas, Qt::Key_Return);
  save("PatchPainting_line_painted");
  press(window, "paint");
  while (bench.painting.canUndo()) press(window, "undo");
  press(window, "toolBrush");
  bench.painting.label = patch::kFalciform;
  bench.painting.radiusMm = 6;
  bench.view.brushChanged.emit();
  scrollTo(window, "purpose");
}

/// What belongs to the window and to no step: keys, dark theme, slices.
void desktopPictures(MainWindow& window, const std::function<void(const QString&)>& save,
                     const std::function<void(QWidget*, const QString&)>& saveOf) {
  const auto trigger = [&](const char* name) { window.findChild<QAction*>(name)->trigger(); };
  trigger("shortcuts");
  QTest::qWait(300);
  if (auto* sheet = window.findChild<QDialog*>("shortcutSheet")) {
    saveOf(sheet, "Desktop_keys");
    sheet->close();
  }
  trigger("ctSlicesWanted");
  save("Desktop_slices");
  trigger("darkTheme");
  save("Desktop_dark");
  trigger("darkTheme");
  trigger("ctSlicesWanted");
}

void tick(MainWindow& window, const char* box, bool on) {
  auto* found = window.currentPanel()->findChild<QAbstractButton*>(box);
  if (found && found->isChecked() != on) found->click();
}

/// A model prepared, the update while it runs, and all that is to be seen of it.
void updatePictures(MainWindow& window, Workbench& bench, const std::function<void(const QString&)>& save) {
  press(window, "prepareUpdate");
  QTest::qWait(500);
  if (bench.runner.busy()) save("AtlasUpdate_preparing");
  waitIdle(bench);
  save("AtlasUpdate_prepared");
  press(window, "updateModel");
  scrollTo(window, "updateModel");
  while (bench.runner.busy() && !bench.view.options().liveDeformed) QTest::qWait(5);
  window.repaint();
  if (bench.runner.busy()) save("AtlasUpdate_settling");
  waitIdle(bench);
  save("AtlasUpdate_updated");
  for (const auto& [colours, name] : std::vector<std::pair<int, QString>>{
           {0, "plain"}, {1, "motion"}, {2, "residual"}, {3, "expected_error"}, {4, "scan_next"}}) {
    take(window, "updateColours", colours);
    scrollTo(window, "confidence");
    save("AtlasUpdate_" + name);
  }
  take(window, "updateColours", 0);
  tick(window, "seeInside", true);
  scrollTo(window, "updateShare");
  save("AtlasUpdate_inside");
  take(window, "updateColours", 1);
  tick(window, "compareViews", true);
  save("AtlasUpdate_compare");
  tick(window, "compareViews", false);
  tick(window, "ctSlices", true);
  scrollTo(window, "targetTable");
  save("AtlasUpdate_slices");
  tick(window, "compareViews", true);
  save("AtlasUpdate_all");
  press(window, "showRigid");
  tick(window, "compareViews", false);
  tick(window, "ctSlices", false);
  tick(window, "seeInside", false);
  scrollTo(window, "updateShare");
  save("AtlasUpdate_rigid");
  press(window, "showUpdated");
}

/// A model prepared, a template on it seen from below and from the front, and a push that is too much.
void supportPictures(MainWindow& window, Workbench& bench, const std::function<void(const QString&)>& save) {
  press(window, "pageSupports");
  QTest::qWait(300);
  press(window, "prepareModel");
  waitIdle(bench);
  press(window, "fillTemplate");
  QTest::qWait(1500);
  const auto view = [&](const char* button) {
    if (auto* found = window.findChild<QAbstractButton*>(button)) found->click();
  };
  press(window, "paintSupport");
  view("viewInferior");
  save("AtlasUpdate_supports");
  press(window, "paintSupport");
  save("AtlasUpdate_packed_below");
  view("viewAnterior");
  scrollTo(window, "fillTemplate");
  save("AtlasUpdate_packed");
  press(window, "displacementColours");
  save("AtlasUpdate_packed_supports");
  press(window, "displacementColours");
  if (auto* push = window.currentPanel()->findChild<QSlider*>("pushMmSlider"))
    push->setValue(push->maximum());
  QTest::qWait(1500);
  scrollTo(window, "supportTable");
  save("AtlasUpdate_too_much");
}

/// A map in its metrics and ranges, and beside other cases.
void deformationPictures(MainWindow& window, Workbench& bench, const QString& others,
                         const std::function<void(const QString&)>& save) {
  const QString name = "DeformationAnalysis";
  auto* metric = window.currentPanel()->findChild<QComboBox*>("metric");
  for (int i = 1; i < metric->count(); ++i) {
    metric->setCurrentIndex(i);
    scrollTo(window, "metric");
    save(name + "_metric" + QString::number(i));
  }
  metric->setCurrentIndex(0);
  const auto type = [&](const char* box, double value) {
    window.currentPanel()->findChild<QDoubleSpinBox*>(box)->setValue(value);
  };
  type("threshold", 2);
  save(name + "_threshold");
  type("threshold", 0);
  tick(window, "rangeSymmetric", false);
  type("rangeLow", -3);
  save(name + "_limits");
  tick(window, "rangeSymmetric", true);
  tick(window, "rangeAutomatic", true);
  if (others.isEmpty()) return;
  dynamic_cast<DeformationAnalysisPanel&>(*window.currentPanel()).compared().open(others);
  waitIdle(bench);
  scrollTo(window, "distanceStatistics");
  save(name + "_cases");
  bench.view.edit([](ViewOptions& options) { options.enlargedCase = 1; });
  save(name + "_case_large");
  bench.view.edit([](ViewOptions& options) { options.enlargedCase = -1; });
}

}  // namespace

/// Walks a case through the modules and saves a picture of the window at each: for eyes, and for the user
/// guide.
///   WindowPictures FOLDER [--only MODULE] [--compare CASES] [CASE or FILE...]
int main(int argc, char** argv) {
  const test::TemporaryFolder settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                     QString::fromStdString(settings.path().string()));
  CaseView3D::prepareApplication();
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication application(argc, argv);
  dressApplication(application);
  if (argc < 2) {
    std::fprintf(stderr,
                 "usage: WindowPictures FOLDER [--only MODULE] [--compare CASES] [CASE or FILE...]\n");
    return 2;
  }
  const QString folder = argv[1];
  Workbench bench;
  QObject::connect(&bench.log, &Log::added,
                   [](Log::Level, const QString& text) { std::puts(qPrintable(text)); });
  MainWindow window(bench);
  window.show();
  QTest::qWait(500);
  const auto save = [&](const QString& name) {
    QTest::qWait(500);
    window.grab().save(folder + "/" + name + ".png");
  };
  save("0_empty");
  QStringList files = QApplication::arguments().mid(2);
  QString only, others;
  while (files.size() > 1 && files.front().startsWith("--")) {
    (files.front() == "--only" ? only : others) = files[1];
    files = files.mid(2);
  }
  window.open(files);
  waitIdle(bench);
  for (const Module& module : moduleList()) {
    if (!only.isEmpty() && only != module.key) continue;
    window.showModule(module.key);
    QTest::qWait(300);
    const QString name = module.key;
    const bool ctAlone = bench.document.ct() && !bench.document.labels() && !bench.document.preop();
    if (name == "SegmentationImport" && ctAlone)
      importPictures(window, bench, save,
                     [&](const QString& picture) { window.grab().save(folder + "/" + picture + ".png"); });
    if (name == "SegmentationImport" && bench.document.labels()) {
      press(window, "import");
      waitIdle(bench);
    }
    if (name == "ScanPreparation" && bench.document.scan()) {
      press(window, "markScan");
      QTest::qWait(15000);  // a preview has no end that the bench would tell of
    }
    if (name == "PatchPainting") {
      save(name + "_liver");
      paintingPictures(window, bench, save);
      press(window, "paintOnScan");
    }
    if (name == "Registration") {
      save(name + "_before");
      press(window, "register");
      QTest::qWait(3000);
      if (bench.runner.busy()) save(name + "_running");
      waitIdle(bench);
    }
    if (name == "DeformationAnalysis") {
      press(window, "compute");
      waitIdle(bench);
    }
    save(name);
    if (name == "Registration" && bench.document.registration()) registrationPictures(window, bench, save);
    if (name == "AtlasUpdate") {
      updatePictures(window, bench, save);
      supportPictures(window, bench, save);
    }
    if (name == "DeformationAnalysis") deformationPictures(window, bench, others, save);
  }
  desktopPictures(window, save,
                  [&](QWidget* of, const QString& name) { of->grab().save(folder + "/" + name + ".png"); });
  return 0;
}
