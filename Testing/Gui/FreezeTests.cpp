#include <QMessageBox>
#include <QMouseEvent>
#include <QtTest/QTest>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Acquisition/VirtualScanner.h"
#include "Logic/IO/CaseFolder.h"
#include "Testing/Gui/SmoothFixture.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

/// A liver of the usual size, painted, and its scan, as a case folder made once.
const std::filesystem::path& caseFolder() {
  static const TemporaryFolder folder;
  static const std::filesystem::path made = [] {
    SyntheticLiverSettings settings;
    settings.voxelMm = 10;  // not used
    const SyntheticLiver liver = makeSyntheticLiver(settings);
    Case document;
    document.setName("Usual size");
    document.setPreop(std::make_shared<const Surface>(liver.surface));
    document.setScan(std::make_shared<const Surface>(scanSurface(liver.surface, {}).scan));
    saveCase(document, folder / "case", Overwrite::Refuse);
    return folder / "case";
  }();
  return made;
}

/// No event may hold the window's thread up for longer than a person takes for "at once".
struct Freeze : SmoothFixture {
  /// The mouse without a button, over the view.
  void hover(const QPoint& at) {
    QWidget* canvas = window->view()->canvas();
    QMouseEvent move(QEvent::MouseMove, at, canvas->mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                     Qt::NoModifier);
    QApplication::sendEvent(canvas, &move);
  }
  void openCase() {
    window->open({QString::fromStdString(caseFolder().string())});
    waitUntil([&] { return bench->document.scan() != nullptr; }, "the case", 60);
    waitIdle();
    handleEvents(300);
  }
};

TEST_F(Freeze, NoStepHoldsTheWindowUpForATenthOfASecond) {
  (void)caseFolder();
  isSmooth("opening the case", [&] { openCase(); });
  ASSERT_TRUE(bench->document.preop());
  isSmooth("going through the steps", [&] {
    for (const char* module :
         {"PatchPainting", "Registration", "DeformationAnalysis", "AtlasUpdate", "PatchPainting"}) {
      window->showModule(module);
      handleEvents(100);
    }
  });
  window->showModule("PatchPainting");
  click("paint");
  const QRect canvas = window->view()->canvas()->rect();
  const QPoint middle = canvas.center();
  isSmooth("the mouse comes over the liver", [&] {
    hover(middle);
    hover(middle + QPoint(9, 4));
    handleEvents(200);
  });
  isSmooth("painting strokes", [&] {
    for (int stroke = 0; stroke < 3; ++stroke) {
      std::vector<QPoint> way;
      for (int i = 0; i <= 20; ++i) way.push_back(middle + QPoint(-120 + 12 * i, -60 + 40 * stroke));
      press(stroke == 1 ? Qt::Key_2 : Qt::Key_3);
      drag(way);
    }
  });
  EXPECT_TRUE(bench->painting.canUndo());
  isSmooth("undo and redo", [&] {
    for (int i = 0; i < 3; ++i) press(Qt::Key_Z);
    for (int i = 0; i < 3; ++i) press(Qt::Key_Y);
  });
  isSmooth("whole-patch operations", [&] {
    for (const char* operation : {"growPatch", "shrinkPatch", "smoothPatch", "largestPiece", "fillHoles"})
      click(operation);
  });
  press(Qt::Key_Escape);
  window->showModule("Registration");
  isSmooth("registering", [&] {
    click("register");
    waitIdle();
  });
  ASSERT_TRUE(bench->document.registration()) << errors.join(" ").toStdString();
  window->showModule("DeformationAnalysis");
  isSmooth("the distance map", [&] {
    click("compute");
    waitIdle();
  });
  ASSERT_TRUE(bench->document.distance()) << errors.join(" ").toStdString();
  isSmooth("saving", [&] {
    trigger("saveCase");
    waitIdle();
  });
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

TEST_F(Freeze, ClosingWhileRegisteringOrMeasuringIsSafe) {
  openCase();
  const auto closeDuring = [&](const char* module, const char* button) {
    window->showModule(module);
    click(button);
    EXPECT_TRUE(bench->runner.busy()) << button;
    answerNext("QMessageBox", [](QWidget* box) {
      QTest::mouseClick(static_cast<QMessageBox*>(box)->button(QMessageBox::Discard), Qt::LeftButton);
    });
    window->close();
    waitUntil([&] { return !window->isVisible(); }, "the window to close", 60);
    EXPECT_FALSE(bench->runner.busy());
    EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
  };
  bench->document.setName("changed");
  closeDuring("Registration", "register");
  openWindow();
  openCase();
  window->showModule("Registration");
  click("register");
  waitIdle();
  closeDuring("DeformationAnalysis", "compute");
}

}  // namespace
}  // namespace falciform::test
