#include <QDir>
#include <QMessageBox>
#include <QtTest/QTest>

#include "Logic/IO/SurfaceFiles.h"
#include "Modules/Application/Recovery.h"
#include "Testing/Gui/WindowFixture.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

struct RecoveryTest : WindowTest {
  void answer(QMessageBox::StandardButton button) {
    answerNext("QMessageBox", [button](QWidget* box) {
      QTest::mouseClick(static_cast<QMessageBox*>(box)->button(button), Qt::LeftButton);
    });
  }
  /// Keeps what there is and loses the session as a crash does: its folder stays, and nobody holds its lock.
  void crash() {
    window->recovery().keep();
    const QString session = window->recovery().session();
    waitUntil([&] { return QFile::exists(session + "/recovery.json"); }, "the state file", 20);
    handleEvents(100);
    left = session + "_left";
    std::filesystem::copy(session.toStdString(), left.toStdString(),
                          std::filesystem::copy_options::recursive);
    QFile::remove(left + "/lock");
    window->recovery().forget();
    openWindow();
  }
  void TearDown() override {
    if (!left.isEmpty()) QDir(left).removeRecursively();
  }
  QString left;
};

TEST_F(RecoveryTest, WhatACrashLeftIsOfferedAndComesBackUnsaved) {
  bench->document.setName("Liver 7");
  bench->document.setPreop(std::make_shared<const Surface>(lumpyBody(3)));
  const auto before = bench->document.preop();
  crash();
  answer(QMessageBox::Open);
  window->offerRecovery();
  waitUntil([&] { return bench->document.preop() != nullptr; }, "the case");
  waitIdle();
  EXPECT_EQ(bench->document.preop()->patch, before->patch);
  EXPECT_EQ(bench->document.preop()->points, before->points);
  EXPECT_EQ(bench->document.name(), "Liver 7");
  EXPECT_TRUE(window->isWindowModified()) << "it is not saved where it belongs";
  EXPECT_TRUE(window->recovery().left().isEmpty()) << "it is not offered twice";
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

TEST_F(RecoveryTest, DiscardedIsGoneCancelledIsAskedAgain) {
  bench->document.setPreop(std::make_shared<const Surface>(sphere(50, 3)));
  crash();
  answer(QMessageBox::Cancel);
  window->offerRecovery();
  ASSERT_EQ(window->recovery().left().size(), 1);
  answer(QMessageBox::Discard);
  window->offerRecovery();
  EXPECT_TRUE(window->recovery().left().isEmpty());
  EXPECT_FALSE(bench->document.preop());
}

TEST_F(RecoveryTest, ASessionThatEndsWellLeavesNothing) {
  const TemporaryFolder folder;
  bench->document.setPreop(std::make_shared<const Surface>(sphere(50, 3)));
  window->recovery().keep();
  const QString session = window->recovery().session();
  waitUntil([&] { return QFile::exists(session + "/recovery.json"); }, "the state file", 20);
  handleEvents(100);
  chooseInNextDialog(QString::fromStdString((folder / "saved").string()));
  trigger("saveCase");
  waitIdle();
  EXPECT_FALSE(QDir(session).exists()) << "saved";
  bench->document.setName("x");
  window->recovery().keep();
  waitUntil([&] { return QFile::exists(session + "/recovery.json"); }, "the state file", 20);
  handleEvents(100);
  answer(QMessageBox::Discard);
  window->close();
  waitUntil([&] { return !window->isVisible(); }, "closing");
  EXPECT_FALSE(QDir(session).exists()) << "discarded";
}

TEST_F(RecoveryTest, AnotherRunningSessionIsNotTouched) {
  bench->document.setPreop(std::make_shared<const Surface>(sphere(50, 3)));
  window->recovery().keep();
  const QString session = window->recovery().session();
  waitUntil([&] { return QFile::exists(session + "/recovery.json"); }, "the state file", 20);
  handleEvents(100);
  Workbench other;
  Recovery second(other, nullptr, QFileInfo(session).absolutePath());
  EXPECT_TRUE(second.left().isEmpty());
  EXPECT_TRUE(QFile::exists(session + "/recovery.json"));
  window->recovery().forget();
}

}  // namespace
}  // namespace falciform::test
