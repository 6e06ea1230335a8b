#include <QAbstractItemView>
#include <QComboBox>
#include <QtTest/QTest>
#include <algorithm>
#include <cmath>

#include "Logic/IO/SurfaceFiles.h"
#include "Logic/Patches/PatchTransfer.h"
#include "Testing/Gui/WindowFixture.h"
#include "Testing/Regression/UpdateCase.h"
#include "Testing/Support/RealData.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

/// A real liver and its scan, bare: what a clinician paints is what a clinician knows.
struct RealLiver : WindowTest {
  void SetUp() override {
    FALCIFORM_NEEDS_DATA("update/ircad17_left");
    WindowTest::SetUp();
    if (IsSkipped()) return;
    truth = readUpdateCase("ircad17_left");
    for (const auto& [surface, name] : {std::pair{&truth.preop, "preop.vtp"}, {&truth.scan, "scan.vtp"}}) {
      Surface bare = *surface;
      bare.patch.clear();
      writeSurface(folder / name, bare, Overwrite::Refuse);
    }
  }
  [[nodiscard]] QString path(const char* name) const {
    return QString::fromStdString((folder / name).string());
  }

  /// Canvas positions along a patch as annotated, from one end to the other: of each slice across its longest
  /// axis the point nearest to the slice's middle.
  std::vector<QPoint> wayAlong(const Surface& annotated, int label, int stops) {
    const std::vector<int> ids = pointsOfPatch(annotated, label);
    Points points(static_cast<Index>(ids.size()), 3);
    for (std::size_t i = 0; i < ids.size(); ++i)
      points.row(static_cast<Index>(i)) = annotated.points.row(ids[i]);
    const Eigen::RowVector3d spread =
        (points.rowwise() - points.colwise().mean()).array().square().colwise().sum().matrix();
    Index axis = 0;
    spread.maxCoeff(&axis);
    const double low = points.col(axis).minCoeff(), high = points.col(axis).maxCoeff();
    std::vector<QPoint> way;
    for (int k = 0; k < stops; ++k) {
      const double from = low + (high - low) * k / stops, to = low + (high - low) * (k + 1) / stops;
      Vector3d middle = Vector3d::Zero();
      int count = 0;
      for (Index i = 0; i < points.rows(); ++i)
        if (points(i, axis) >= from && points(i, axis) <= to) {
          middle += points.row(i).transpose();
          ++count;
        }
      if (count == 0) continue;
      middle /= count;
      Index nearest = 0;
      (points.rowwise() - middle.transpose()).rowwise().norm().minCoeff(&nearest);
      way.push_back(window->view()->canvasPosition(points.row(nearest).transpose()));
    }
    return way;
  }

  /// The share of what is painted that lies within 8 mm of the annotated patch: brush and a little.
  static double goodShare(const Surface& painted, const Surface& annotated, int label) {
    const std::vector<int> ids = pointsOfPatch(painted, label);
    Surface only = annotated;
    for (int& value : only.patch) value = value == label ? label : patch::kNone;
    const std::vector<int> near = transferPatches(only, painted, 8);
    const auto good = std::count_if(ids.begin(), ids.end(),
                                    [&](int id) { return near[static_cast<std::size_t>(id)] == label; });
    return ids.empty() ? 0 : static_cast<double>(good) / static_cast<double>(ids.size());
  }

  /// Paints one patch by a drag, takes it back and brings it again.
  void paint(int key, const Surface& annotated, int label, int stops, bool onScan) {
    press(key);
    const auto surface = [&] { return onScan ? bench->document.scan() : bench->document.preop(); };
    const auto before = surface()->patch;
    drag(wayAlong(annotated, label, stops));
    const std::vector<int> painted = pointsOfPatch(*surface(), label);
    ASSERT_GT(painted.size(), 40u) << label;
    EXPECT_GT(goodShare(*surface(), annotated, label), 0.6)
        << label << (onScan ? " on the scan" : " on the liver");
    press(Qt::Key_Z);
    EXPECT_TRUE(pointsOfPatch(*surface(), label).empty());
    press(Qt::Key_Y);
    EXPECT_EQ(pointsOfPatch(*surface(), label), painted);
  }

  /// All that a table or tree says.
  QStringList wordsOf(const char* name) {
    const QAbstractItemModel* model = control<QAbstractItemView>(name).model();
    QStringList words;
    for (int row = 0; row < model->rowCount(); ++row)
      for (int column = 0; column < model->columnCount(); ++column)
        words << model->index(row, column).data().toString();
    return words;
  }

  UpdateCase truth;
  TemporaryFolder folder;
};

TEST_F(RealLiver, IsOpenedPaintedRegisteredMeasuredSavedAndReopenedByMouseAndKeyboard) {
  // 1. Liver and scan are dropped on the window; the names tell what they are.
  drop({path("preop.vtp"), path("scan.vtp")});
  waitUntil([&] { return bench->document.scan() != nullptr; }, "both files", 60);
  waitIdle();
  ASSERT_TRUE(bench->document.preop()) << errors.join(" ").toStdString();
  keepPicture("real_1_opened");

  // 2. "Next" leads to painting; falciform from the front, ridge from below.
  click("nextStep");
  ASSERT_EQ(window->currentPanel()->objectName(), "PatchPainting");
  handleEvents(300);
  click("paint");
  paint(Qt::Key_1, truth.preop, patch::kFalciform, 12, false);
  QTest::keyClick(window->view()->canvas(), 'I', Qt::ShiftModifier);
  handleEvents(200);
  paint(Qt::Key_2, truth.preop, patch::kInferiorRidge, 24, false);
  keepPicture("real_2_liver_painted");
  click("paintOnScan");
  handleEvents(300);
  paint(Qt::Key_1, truth.scan, patch::kFalciform, 10, true);
  paint(Qt::Key_2, truth.scan, patch::kInferiorRidge, 24, true);
  keepPicture("real_3_scan_painted");
  press(Qt::Key_Escape);

  // 3. Register: about as near to the targets as the best rigid motion there is.
  click("nextStep");
  ASSERT_EQ(window->currentPanel()->objectName(), "Registration");
  click("register");
  waitIdle();
  ASSERT_TRUE(bench->document.registration()) << errors.join(" ").toStdString();
  const Points moved = transformed(truth.targetsPreop, bench->document.registration()->scanFromPreop);
  const double error = (moved - truth.targetsScanner).rowwise().norm().mean();
  EXPECT_LT(error, 1.4 * truth.optimalRigidMm + 0.5) << "mm, the measure of Docs/Performance.md";
  const QStringList registered = wordsOf("registrationResult");
  keepPicture("real_4_registered");

  // 4. The distance map, read from its table.
  click("nextStep");
  ASSERT_EQ(window->currentPanel()->objectName(), "DeformationAnalysis");
  click("compute");
  waitIdle();
  ASSERT_TRUE(bench->document.distance()) << errors.join(" ").toStdString();
  const QStringList distances = wordsOf("distanceStatistics");
  ASSERT_FALSE(distances.isEmpty());
  keepPicture("real_5_distances");

  // 5. Save, reopen in a new window: the same vertices and the same figures.
  const auto preop = bench->document.preop(), scan = bench->document.scan();
  const auto map = bench->document.distance();
  const Isometry3d pose = bench->document.registration()->scanFromPreop;
  chooseInNextDialog(path("saved"));
  trigger("saveCase");
  waitIdle();
  EXPECT_FALSE(window->isWindowModified()) << errors.join(" ").toStdString();
  openWindow();
  window->open({path("saved")});
  waitUntil([&] { return bench->document.scan() != nullptr; }, "the saved case", 60);
  waitIdle();
  EXPECT_EQ(bench->document.preop()->points, preop->points);
  EXPECT_EQ(bench->document.preop()->triangles, preop->triangles);
  EXPECT_EQ(bench->document.preop()->patch, preop->patch);
  EXPECT_EQ(bench->document.scan()->points, scan->points);
  EXPECT_EQ(bench->document.scan()->patch, scan->patch);
  EXPECT_EQ(bench->document.registration()->scanFromPreop.matrix(), pose.matrix());
  EXPECT_EQ(bench->document.distance()->scanAll.rms, map->scanAll.rms);
  EXPECT_EQ(window->currentPanel()->objectName(), "DeformationAnalysis") << "and where it was left";
  EXPECT_EQ(wordsOf("distanceStatistics"), distances);
  window->showModule("Registration");
  handleEvents(100);
  EXPECT_EQ(wordsOf("registrationResult"), registered);
  keepPicture("real_6_reopened");
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

}  // namespace
}  // namespace falciform::test
