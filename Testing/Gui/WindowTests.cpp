#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QTimer>
#include <QtTest/QTest>
#include <chrono>
#include <cmath>
#include <thread>

#include "Logic/Core/Errors.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Modules/ModuleList.h"
#include "Modules/Registration/RegistrationPanel.h"
#include "Testing/Gui/WindowFixture.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

/// A job that runs until it is stopped, and is slow to notice.
int endless(const Progress& progress) {
  for (;;) {
    progress.report(0.5, "working");
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
  }
}

void answerUnsaved(WindowTest& test, QMessageBox::StandardButton button) {
  test.answerNext("QMessageBox", [button](QWidget* box) {
    QTest::mouseClick(static_cast<QMessageBox*>(box)->button(button), Qt::LeftButton);
  });
}

TEST_F(WindowTest, EveryModuleOpensByTheSelectorAndByTheArrows) {
  auto& selector = control<QComboBox>("moduleSelector");
  ASSERT_EQ(selector.count(), static_cast<int>(moduleList().size()));
  for (int i = 0; i < selector.count(); ++i) {
    selector.setFocus();
    if (i > 0) QTest::keyClick(&selector, Qt::Key_Down);
    EXPECT_EQ(window->currentPanel()->objectName(), moduleList()[static_cast<std::size_t>(i)].key);
    EXPECT_TRUE(window->currentPanel()->isVisible());
    handleEvents(20);
  }
  click("previousModule");
  EXPECT_EQ(window->currentPanel()->objectName(), "DeformationAnalysis");
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

TEST_F(WindowTest, TheTitleSaysResearchUseOnlyAndMarksChanges) {
  EXPECT_TRUE(window->windowTitle().contains("Research use only: not a medical device"));
  EXPECT_FALSE(window->isWindowModified());
  bench->document.setName("Case 1");
  EXPECT_TRUE(window->windowTitle().startsWith("Case 1"));
  EXPECT_TRUE(window->isWindowModified());
}

TEST_F(WindowTest, NoPanelIsWiderThanItsPlace) {
  for (const Module& module : moduleList()) {
    window->showModule(module.key);
    handleEvents(20);
    const QWidget* place = window->currentPanel()->parentWidget();
    EXPECT_LE(window->currentPanel()->minimumSizeHint().width(), place->width()) << module.key;
  }
}

TEST_F(WindowTest, ADropIsGuessedByItsNameAndAskedForWhereItDoesNotTell) {
  const TemporaryFolder folder;
  for (const char* name : {"scan_1.vtp", "thing.vtp"})
    writeSurface(folder / name, sphere(50, 3), Overwrite::Refuse);
  drop({QString::fromStdString((folder / "scan_1.vtp").string())});
  waitUntil([&] { return bench->document.scan() != nullptr; }, "the scan");
  QStringList offered;
  answerNext("QInputDialog", [&](QWidget* dialog) {
    auto* list = dialog->findChild<QComboBox*>();
    for (int i = 0; i < list->count(); ++i) offered << list->itemText(i);
    QTest::keyClick(dialog, Qt::Key_Return);
  });
  drop({QString::fromStdString((folder / "thing.vtp").string())});
  waitUntil([&] { return bench->document.preop() != nullptr; }, "the surface");
  EXPECT_EQ(offered.size(), 3);
}

TEST_F(WindowTest, FilesOfTheCommandLineOpenOneAfterTheOther) {
  const TemporaryFolder folder;
  QStringList files;
  for (const char* name : {"preop.vtp", "scan.vtp", "portal_vein.vtp"}) {
    writeSurface(folder / name, sphere(50, 3), Overwrite::Refuse);
    files << QString::fromStdString((folder / name).string());
  }
  files << QString::fromStdString((folder / "gone.vtp").string());
  window->open(files);
  waitUntil([&] { return !bench->document.structures().empty() && !errors.isEmpty(); }, "all files");
  EXPECT_TRUE(bench->document.preop() && bench->document.scan());
  EXPECT_TRUE(errors.join(" ").contains("gone.vtp"));
}

TEST_F(WindowTest, ClosingDuringAJobStopsItFirstAndThenCloses) {
  bool accepted = false;
  bench->runner.start("Working", endless, [&](int) { accepted = true; });
  handleEvents();
  window->close();
  EXPECT_TRUE(window->isVisible()) << "it waits for the job, without freezing";
  waitUntil([&] { return !window->isVisible(); }, "the window to close", 10);
  EXPECT_FALSE(bench->runner.busy());
  EXPECT_FALSE(accepted);
}

TEST_F(WindowTest, DestroyingTheWindowDuringAJobIsSafe) {
  bench->document.setPreop(std::make_shared<const Surface>(sphere(50, 4)));
  bench->runner.start("Working", endless, [](int) {});
  handleEvents();
  closeWindow();
  QApplication::processEvents();
  SUCCEED() << "no crash, no job left";
}

TEST_F(WindowTest, CancelStopsTheJobAndSaysSo) {
  bench->runner.start("Working", endless, [](int) {});
  waitUntil([&] { return control<QLabel>("jobText").text().contains("working"); }, "the stage's text", 10);
  click("jobCancel");
  waitUntil([&] { return !bench->runner.busy(); }, "the job's end", 10);
  EXPECT_TRUE(control<QLabel>("jobText").text().contains("stopped"));
}

TEST_F(WindowTest, StopKeepsThePoseOfTheLastIterationAndTheCurve) {
  bench->document.setPreop(std::make_shared<const Surface>(lumpyBody(5)));
  bench->document.setScan(
      std::make_shared<const Surface>(transformed(lumpyBody(5), randomMotion(3, 50), "scanner")));
  window->showModule("Registration");
  auto* panel = qobject_cast<RegistrationPanel*>(window->currentPanel());
  ASSERT_TRUE(panel);
  panel->logic().settings.finish = RegistrationFinish::None;
  panel->logic().settings.relaxation = 1e-4;  // the patch weight falls over tens of thousands of iterations
  panel->logic().settings.maxIterations = 100000;
  click("register");
  waitUntil([&] { return bench->view.options().livePreopFromScan.has_value(); }, "the first iterations");
  click("stop");
  waitIdle();
  const auto& kept = bench->document.registration();
  ASSERT_TRUE(kept) << errors.join(" ").toStdString();
  EXPECT_EQ(kept->stopReason, "stopped by the user");
  EXPECT_TRUE(std::isfinite(kept->coverage)) << "its figures were filled in afterwards";
  EXPECT_FALSE(kept->patchRmsMm.empty());
  ASSERT_FALSE(kept->history.empty());
  EXPECT_TRUE(kept->scanFromPreop.isApprox(kept->history.back().preopFromScan.inverse(), 1e-12));
  EXPECT_FALSE(bench->view.options().livePreopFromScan.has_value());
}

TEST_F(WindowTest, UnsavedChangesAreNotLostWithoutAQuestion) {
  const TemporaryFolder folder;
  bench->document.setPreop(std::make_shared<const Surface>(sphere(50, 3)));
  answerUnsaved(*this, QMessageBox::Cancel);
  window->close();
  handleEvents();
  EXPECT_TRUE(window->isVisible());
  EXPECT_TRUE(bench->document.preop());

  answerUnsaved(*this, QMessageBox::Cancel);
  trigger("newCase");
  EXPECT_TRUE(bench->document.preop()) << "turned back";
  answerUnsaved(*this, QMessageBox::Discard);
  trigger("newCase");
  EXPECT_FALSE(bench->document.preop()) << "discarded";

  bench->document.setPreop(std::make_shared<const Surface>(sphere(50, 3)));
  answerNext("QMessageBox", [&](QWidget* box) {
    chooseInNextDialog(QString::fromStdString((folder / "saved").string()));
    QTest::mouseClick(static_cast<QMessageBox*>(box)->button(QMessageBox::Save), Qt::LeftButton);
  });
  window->close();
  waitUntil([&] { return !window->isVisible(); }, "saving, then closing", 30);
  EXPECT_TRUE(std::filesystem::exists(folder / "saved" / "case.json")) << errors.join(" ").toStdString();
}

TEST_F(WindowTest, AnUnchangedCaseClosesWithoutAQuestion) {
  window->close();
  waitUntil([&] { return !window->isVisible(); }, "the window to close", 10);
}

TEST_F(WindowTest, TheEventLoopKeepsTurningWhileAJobRuns) {
  int turns = 0;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&] { ++turns; });
  timer.start(10);
  bench->runner.start(
      "Working",
      [](const Progress&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(600));
        return 0;
      },
      [](int) {});
  waitIdle();
  EXPECT_GE(turns, 10);  // of 60 possible; the rest is room for a busy machine
}

}  // namespace
}  // namespace falciform::test
