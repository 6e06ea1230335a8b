#include <algorithm>

#include <QAction>
#include <QDialog>
#include <QMenu>
#include <QMenuBar>
#include <QTextBrowser>
#include <QToolButton>
#include <QTreeWidget>
#include <QtTest/QTest>

#include "Modules/Application/Appearance.h"
#include "Modules/ModuleList.h"
#include "Testing/Gui/WindowFixture.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"
#include "Widgets/Views/CaseSlices.h"
#include "Widgets/Views/CaseViews.h"

namespace falciform::test {
namespace {

struct Desktop : WindowTest {
  void openLiver() {
    bench->document.setPreop(std::make_shared<const Surface>(lumpyBody(4)));
    handleEvents(200);
  }
};

TEST_F(Desktop, F1ShowsEveryKeyOfTheMenusAndEscClosesIt) {
  // Without a window manager no window is active, and keys of menus go to active ones alone.
  const QList<QKeySequence> keysOfTheSheet = window->findChild<QAction*>("shortcuts")->shortcuts();
  EXPECT_TRUE(keysOfTheSheet.contains(QKeySequence("F1")) && keysOfTheSheet.contains(QKeySequence("?")));
  trigger("shortcuts");
  handleEvents();
  auto* sheet = window->findChild<QDialog*>("shortcutSheet");
  ASSERT_TRUE(sheet && sheet->isVisible());
  const QString text = sheet->findChild<QTextBrowser*>("shortcutText")->toPlainText();
  int keys = 0;
  for (const QAction* action : window->findChildren<QAction*>()) {
    if (action->shortcut().isEmpty() || action->objectName().isEmpty()) continue;
    const QList<QWidget*> owners = action->associatedWidgets();
    if (std::none_of(owners.begin(), owners.end(), [](QWidget* w) { return qobject_cast<QMenu*>(w); }))
      continue;
    ++keys;
    EXPECT_TRUE(text.contains(action->shortcut().toString(QKeySequence::NativeText)))
        << action->objectName().toStdString();
  }
  EXPECT_GE(keys, 12);
  QTest::keyClick(sheet, Qt::Key_Escape);
  handleEvents();
  EXPECT_FALSE(window->findChild<QDialog*>("shortcutSheet") && sheet->isVisible());
}

TEST_F(Desktop, EveryControlOfTheWindowHasANameAndATooltip) {
  openLiver();
  bench->view.edit([](ViewOptions& options) { options.slicesWanted = true; });
  handleEvents(100);
  for (const QAbstractButton* button : window->findChildren<QAbstractButton*>()) {
    if (!button->isVisible() || button->objectName().startsWith("qt_")) continue;
    EXPECT_FALSE(button->objectName().isEmpty()) << button->metaObject()->className();
    EXPECT_FALSE(button->toolTip().isEmpty()) << button->objectName().toStdString();
  }
  for (const QAction* action : window->findChildren<QAction*>())
    if (!action->objectName().isEmpty() && !action->menu()) {
      EXPECT_FALSE(action->toolTip().isEmpty()) << action->objectName().toStdString();
    }
}

TEST_F(Desktop, NoTwoMenuEntriesShareAKey) {
  std::map<QString, QString> taken;
  for (const QAction* action : window->findChildren<QAction*>())
    for (const QKeySequence& key : action->shortcuts()) {
      EXPECT_FALSE(taken.count(key.toString()))
          << key.toString().toStdString() << ": " << action->objectName().toStdString() << " and "
          << taken[key.toString()].toStdString();
      taken[key.toString()] = action->objectName();
    }
}

TEST_F(Desktop, TheDarkThemeIsDarkAndKept) {
  const auto brightness = [&] {
    const QImage picture = window->grab().toImage();
    double sum = 0;
    int count = 0;
    for (int y = 0; y < picture.height(); y += 7)
      for (int x = 0; x < picture.width(); x += 7, ++count) sum += qGray(picture.pixel(x, y));
    return sum / count;
  };
  openLiver();
  handleEvents(200);
  const double light = brightness();
  trigger("darkTheme");
  handleEvents(300);
  keepPicture("dark_theme");
  EXPECT_LT(brightness(), 0.62 * light);
  EXPECT_TRUE(darkTheme());
  trigger("darkTheme");
  handleEvents(300);
  EXPECT_NEAR(brightness(), light, 6) << "of 255";
  EXPECT_FALSE(darkTheme());
}

TEST_F(Desktop, CtSlicesComeAndGoInAnyStep) {
  openLiver();
  Image ct;
  ct.size = {40, 30, 20};
  ct.worldFromIndex.diagonal() << 4, 4, 6, 1;
  ct.voxels.assign(40 * 30 * 20, 60);
  bench->document.setCt(std::make_shared<const Image>(ct));
  trigger("ctSlicesWanted");
  handleEvents(100);
  ASSERT_TRUE(window->views().slices());
  EXPECT_TRUE(window->views().slices()->isVisible());
  for (const Module& module : moduleList()) {
    window->showModule(module.key);
    handleEvents(50);
    EXPECT_TRUE(window->views().slices()->isVisible()) << module.key;
  }
  trigger("ctSlicesWanted");
  handleEvents(100);
  EXPECT_FALSE(window->views().slices()->isVisible());
}

TEST_F(Desktop, TheNextStepIsNamedAndAClickGoesThere) {
  EXPECT_TRUE(control<QToolButton>("nextStep").text().contains("open"));
  bench->document.setPreop(std::make_shared<const Surface>(sphere(50, 3)));
  bench->document.setScan(std::make_shared<const Surface>(sphere(50, 3)));
  EXPECT_TRUE(control<QToolButton>("nextStep").text().contains("paint"));
  click("nextStep");
  EXPECT_EQ(window->currentPanel()->objectName(), "PatchPainting");
  EXPECT_EQ(bench->painting.target, PaintTarget::Preop);
}

TEST_F(Desktop, TargetsAreDrawnAndHideWithTheirRow) {
  openLiver();
  PartLook glass = bench->view.look(part::kPreop);
  glass.opacity = 0.2;
  bench->view.setLook(part::kPreop, glass);
  bench->document.setTargets({{{"t1", {0, 0, 0}}}, "LPS"});
  handleEvents(300);
  const auto pinkish = [&] {
    const QImage picture = window->view()->canvas()->grab().toImage();
    const QPoint at = window->view()->canvasPosition({0, 0, 0});
    int count = 0;
    for (int dy = -4; dy <= 4; ++dy)
      for (int dx = -4; dx <= 4; ++dx) {
        const QColor colour = picture.pixelColor(at + QPoint(dx, dy));
        count += colour.blue() > colour.green() + 20 ? 1 : 0;
      }
    return count;
  };
  EXPECT_GT(pinkish(), 15) << "pixels of a dot 12 wide, under liver of 20 %";
  PartLook hidden = bench->view.look(part::kTargets);
  hidden.visible = false;
  bench->view.setLook(part::kTargets, hidden);
  handleEvents(300);
  EXPECT_EQ(pinkish(), 0);
}

TEST_F(Desktop, ASavedCaseComesBackAsItWasLookedAt) {
  const TemporaryFolder folder;
  openLiver();
  window->showModule("PatchPainting");
  bench->painting.setLocked(2, true);
  bench->view.setPatchLook(1, {false, {0.1, 0.9, 0.2}});
  PartLook look = bench->view.look(part::kPreop);
  look.opacity = 0.5;
  look.colour = {0.2, 0.4, 0.6};
  bench->view.setLook(part::kPreop, look);
  handleEvents(200);
  QTest::keyClick(window->view()->canvas(), 'L', Qt::ShiftModifier);
  handleEvents(200);
  const std::vector<double> camera = window->view()->camera();
  chooseInNextDialog(QString::fromStdString((folder / "saved").string()));
  trigger("saveCase");
  waitIdle();
  openWindow();
  window->open({QString::fromStdString((folder / "saved").string())});
  waitUntil([&] { return bench->document.preop() != nullptr; }, "the case");
  waitIdle();
  handleEvents(300);
  EXPECT_EQ(window->currentPanel()->objectName(), "PatchPainting");
  EXPECT_EQ(bench->view.look(part::kPreop), look);
  EXPECT_EQ(bench->view.patchLook(1), (PatchLook{false, {0.1, 0.9, 0.2}}));
  EXPECT_EQ(bench->painting.locked(), std::set<int>{2});
  ASSERT_EQ(camera.size(), 10u);
  for (std::size_t i = 0; i < camera.size(); ++i)
    EXPECT_NEAR(window->view()->camera()[i], camera[i], 1e-6) << i;
  EXPECT_FALSE(window->isWindowModified());
}

TEST_F(Desktop, LongNamesInTheCaseAreReadWhole) {
  openLiver();
  bench->document.setPreopLandmarks({{{"a", {1, 2, 3}}}, "LPS"});
  bench->document.setScan(std::make_shared<const Surface>(sphere(50, 3)));
  bench->document.setScanLandmarks({{{"a", {1, 2, 3}}}, "scanner"});
  handleEvents(100);
  auto& tree = control<QTreeWidget>("caseTree");
  for (int i = 0; i < tree.topLevelItemCount(); ++i) {
    const QTreeWidgetItem* item = tree.topLevelItem(i);
    const int room = tree.columnWidth(0) - 26;  // the tick and its margins
    EXPECT_LE(tree.fontMetrics().horizontalAdvance(item->text(0)), room) << item->text(0).toStdString();
    EXPECT_TRUE(item->toolTip(0).contains(item->text(0)) || item->isFirstColumnSpanned());
  }
}

}  // namespace
}  // namespace falciform::test
