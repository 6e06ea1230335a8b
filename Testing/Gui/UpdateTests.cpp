#include <QApplication>
#include <QLabel>
#include <QSlider>
#include <QTableWidget>
#include <QtTest/QTest>

#include "Logic/IO/CaseFolder.h"
#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Modules/AtlasUpdate/AtlasUpdatePanel.h"
#include "Modules/AtlasUpdate/UpdatePage.h"
#include "Testing/Gui/WindowFixture.h"
#include "Testing/Support/LiftedLiver.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"
#include "Widgets/Views/SliceView.h"

namespace falciform::test {
namespace {

/// A case folder as it comes from the operating room: a painted liver, what is in it, a painted scan of it as
/// bent, targets and, since it is a trial, where they truly are.
struct UpdatePath : WindowTest {
  void SetUp() override {
    WindowTest::SetUp();
    if (IsSkipped()) return;
    Case document;
    fillLifted(document, kLiftMm, pose);
    document.setRegistration(nullptr);
    document.setTruthTargets(truthOfLifted(kLiftMm, pose));
    saveCase(document, (folder / "case"), Overwrite::Refuse);
  }
  [[nodiscard]] QString path(const char* name) const {
    return QString::fromStdString((folder / name).string());
  }
  void prepareAndUpdate() {
    type("edgeLengthMm", "25");
    click("prepareUpdate");
    waitIdle();
    click("updateModel");
    waitIdle();
    ASSERT_TRUE(page().maps()) << errors.join(" ").toStdString();
  }
  UpdatePage& page() { return dynamic_cast<AtlasUpdatePanel&>(*window->currentPanel()).update(); }
  [[nodiscard]] std::vector<QStringList> tableTexts() {
    auto& table = control<QTableWidget>("targetTable");
    std::vector<QStringList> rows;
    for (int row = 0; row < table.rowCount(); ++row) {
      rows.emplace_back();
      for (int column = 0; column < table.columnCount(); ++column)
        rows.back() << table.item(row, column)->text();
    }
    return rows;
  }

  static constexpr double kLiftMm = 12;
  Isometry3d pose = randomMotion(3, 20);
  TemporaryFolder folder;
};

TEST_F(UpdatePath, FromACaseToWhereTheTumoursAreNowByMouseAndKeyboard) {
  drop({path("case")});
  waitUntil([&] { return bench->document.scan() != nullptr; }, "the case");
  waitIdle();
  window->showModule("Registration");
  click("register");
  waitIdle();
  ASSERT_TRUE(bench->document.registration()) << errors.join(" ").toStdString();
  click("nextModule");
  click("nextModule");
  prepareAndUpdate();
  handleEvents(200);

  // What is on screen follows the buttons, and the keyboard.
  const auto shown = [&] { return bench->view.options().liveDeformed; };
  EXPECT_EQ(shown(), page().maps()->updated);
  click("showRigid");
  EXPECT_TRUE(shown()->points == bench->document.preop()->points);
  click("showUpdated");
  EXPECT_EQ(shown(), page().maps()->updated);
  QApplication::setActiveWindow(window.get());  // no window manager does it here
  QTest::keyClick(window->view()->canvas(), Qt::Key_T, Qt::ControlModifier);
  EXPECT_TRUE(shown()->points == bench->document.preop()->points) << "Ctrl+T goes to and fro";
  QTest::keyClick(window->view()->canvas(), Qt::Key_T, Qt::ControlModifier);
  EXPECT_EQ(shown(), page().maps()->updated);

  // Two views that look from the same place, and cuts that follow a click.
  click("compareViews");
  click("ctSlices");
  click("seeInside");
  handleEvents(300);
  auto& compared = control<CaseView3D>("comparedView3D");
  EXPECT_TRUE(compared.isVisible());
  const Vector3d middle = bench->document.preop()->points.colwise().mean();
  EXPECT_LT((compared.canvasPosition(middle) - window->view()->canvasPosition(middle)).manhattanLength(), 6)
      << "pixels; the two canvases may differ by a few in width";
  auto& axial = control<SliceView>("sliceAxial");
  const Vector3d tumour = page().maps()->of->targets.front().before;
  QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.positionOf(tumour).toPoint());
  EXPECT_NEAR(control<SliceView>("sliceCoronal").cursorMm().y(), tumour.y(), 2) << "mm; a pixel is about 1";
  if (qEnvironmentVariableIsSet("FALCIFORM_ARTEFACTS"))
    window->grab().save(qEnvironmentVariable("FALCIFORM_ARTEFACTS") + "/update_path.png");

  // The table: in this trial the update is nearer to the truth than the rigid registration.
  const std::vector<QStringList> rows = tableTexts();
  double updated = 0, rigid = 0;
  const std::size_t targets = bench->document.targets().points.size();
  for (std::size_t row = 0; row < targets; ++row) {
    EXPECT_GT(rows[row][2].toDouble(), 0) << "an expected error for " << rows[row][0].toStdString();
    updated += rows[row][3].toDouble();
    rigid += rows[row][4].toDouble();
  }
  EXPECT_LT(updated, rigid);
  EXPECT_TRUE(control<QLabel>("confidence").text().contains("Expected error"));

  // Saved files hold what is shown.
  for (const auto& [button, file] : std::vector<std::pair<const char*, const char*>>{
           {"saveUpdated", "u.vtp"}, {"saveUpdatedTargets", "t.mrk.json"}, {"saveUpdatePicture", "p.png"}}) {
    chooseInNextDialog(path(file));
    click(button);
    waitIdle();
    EXPECT_TRUE(std::filesystem::exists(folder / file)) << button;
  }
  const UpdatedCase& made = *page().maps()->of;
  const Surface surface = readSurface(folder / "u.vtp").value;
  // mm; single precision at some 300 mm.
  EXPECT_LT((surface.points - made.surface->points).cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_TRUE(surface.arrays.contains(kExpectedError));
  const Landmarks saved = readLandmarks(folder / "t.mrk.json").value;
  ASSERT_EQ(saved.points.size(), targets);
  EXPECT_LT((saved.points[1].position - made.targets[1].now).norm(), 1e-3) << "mm; written to the micrometre";

  // Saved, opened again, updated again: the same.
  chooseInNextDialog(path("saved"));
  trigger("saveCaseAs");
  waitIdle();
  openWindow();
  window->open({path("saved")});
  waitUntil([&] { return bench->document.registration() != nullptr; }, "the saved case");
  waitIdle();
  window->showModule("AtlasUpdate");
  prepareAndUpdate();
  EXPECT_EQ(tableTexts(), rows);
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

}  // namespace
}  // namespace falciform::test
