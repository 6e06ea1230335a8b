#include <QApplication>
#include <QImage>
#include <QLabel>
#include <QRegularExpression>
#include <QTableWidget>
#include <QtTest/QTest>

#include "Logic/IO/CaseFolder.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Gui/WindowFixture.h"
#include "Testing/Support/MappedSpheres.h"
#include "Testing/Support/TemporaryFolder.h"
#include "Widgets/Rendering/MapGalleryScene.h"
#include "Widgets/Views/CaseViews.h"
#include "Widgets/Views/MapGalleryView.h"
#include "Widgets/Views/RangeHistogram.h"

namespace falciform::test {
namespace {

/// Two case folders: spheres whose scans lie 2 and 5 mm outside, without their right side. Of the first no
/// map is saved either: it is computed.
struct DeformationPath : WindowTest {
  void SetUp() override {
    WindowTest::SetUp();
    if (IsSkipped()) return;
    save("near", 2);
    save("far", 5);
    drop({path("near")});
    waitUntil([&] { return bench->document.scan() != nullptr; }, "the case");
    waitIdle();
    window->showModule("DeformationAnalysis");
    click("compute");
    waitIdle();
    handleEvents(200);
  }
  void save(const std::string& name, double gapMm) {
    Case document;
    fillSpheres(document, gapMm, pose);
    const auto registration = document.registration();
    Surface seen = transformed(*document.scan(), pose.inverse(), "LPS");
    Surface half;
    std::vector<int> ids;
    for (int i = 0; i < seen.size(); ++i)
      if (seen.points(i, 0) > 0) ids.push_back(i);
    half.points = transformed(Points(seen.points(ids, Eigen::all)), pose);
    half.frame = "scanner";
    document.setScan(std::make_shared<const Surface>(half));
    document.setRegistration(registration);
    document.setName(name);
    saveCase(document, folder / name, Overwrite::Refuse);
  }
  [[nodiscard]] QString path(const char* name) const {
    return QString::fromStdString((folder / name).string());
  }
  /// What the line below the view says once the mouse rests there.
  QString hover(QWidget* canvas, const QPoint& at, const char* label) {
    control<QLabel>(label).clear();
    QTest::mouseMove(canvas, at);
    QMouseEvent move(QEvent::MouseMove, at, canvas->mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                     Qt::NoModifier);
    QApplication::sendEvent(canvas, &move);
    waitUntil([&] { return !control<QLabel>(label).text().isEmpty(); }, "the probe", 10);
    return control<QLabel>(label).text();
  }
  static double distanceIn(const QString& words) {
    const auto found = QRegularExpression("signed distance ([+-][0-9.]+) mm").match(words);
    return found.hasMatch() ? found.captured(1).toDouble() : std::nan("");
  }
  static void dragIn(QWidget* widget, const QPoint& from, const QPoint& to) {
    QTest::mousePress(widget, Qt::LeftButton, {}, from);
    for (const double share : {0.3, 0.7, 1.0}) {
      const QPoint at = from + share * (to - from);
      QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                       Qt::NoModifier);
      QApplication::sendEvent(widget, &move);
    }
    QTest::mouseRelease(widget, Qt::LeftButton, {}, to);
  }
  void keepPicture(const QString& name) {
    if (qEnvironmentVariableIsSet("FALCIFORM_ARTEFACTS"))
      window->grab().save(qEnvironmentVariable("FALCIFORM_ARTEFACTS") + "/" + name + ".png");
  }

  TemporaryFolder folder;
  Isometry3d pose = randomMotion(11, 40);
  const double radiusMm = 50;
};

TEST_F(DeformationPath, TheMouseReadsValuesAndDragsTheLimitsOfTheColours) {
  ASSERT_TRUE(bench->document.distance()) << errors.join(" ").toStdString();
  const Vector3d left(radiusMm * 0.6, -radiusMm * 0.8, 0), right(-radiusMm * 0.6, -radiusMm * 0.8, 0);
  QWidget* canvas = window->view()->canvas();
  const QString there = hover(canvas, window->view()->canvasPosition(left), "probe");
  // mm; a cloud of points 3 mm apart, 2 mm above: the nearest is up to half a spacing aside.
  EXPECT_NEAR(distanceIn(there), 2, 0.6) << there.toStdString();
  EXPECT_TRUE(there.startsWith("Pre-op liver")) << there.toStdString();
  EXPECT_TRUE(there.contains("mm LPS")) << there.toStdString();
  const auto place = QRegularExpression("\\(([-0-9.]+), ([-0-9.]+), ([-0-9.]+)\\)").match(there);
  ASSERT_TRUE(place.hasMatch());
  // mm; a pixel is about 0.3 mm, and flat triangles lie a little inside the sphere.
  EXPECT_NEAR(place.captured(1).toDouble(), left.x(), 1.5) << there.toStdString();
  EXPECT_NEAR(place.captured(3).toDouble(), left.z(), 1.5) << there.toStdString();
  const QString uncovered = hover(canvas, window->view()->canvasPosition(right), "probe");
  EXPECT_TRUE(uncovered.contains("not covered")) << uncovered.toStdString();
  const QString patch = hover(canvas, window->view()->canvasPosition({5, -30, 40}), "probe");
  EXPECT_TRUE(patch.contains("falciform")) << patch.toStdString();

  auto& histogram = control<RangeHistogram>("histogram");
  const auto handle = [&](double value) {
    return QPoint(static_cast<int>(std::lround(histogram.positionOf(value))), histogram.height() / 2);
  };
  const double before = bench->view.options().distanceColours.high, wanted = 0.6 * before;
  dragIn(&histogram, handle(before), handle(wanted));
  handleEvents();
  const ScalarMap& colours = bench->view.options().distanceColours;
  const double pixelMm = histogram.valueAt(1) - histogram.valueAt(0);
  EXPECT_NEAR(colours.high, wanted, 3 * pixelMm + before / 100);
  EXPECT_EQ(colours.low, -colours.high) << "symmetric unless asked otherwise";
  keepPicture("deformation_limits");

  // The picture that is saved is the view's, with the notice.
  chooseInNextDialog(path("map.png"));
  trigger("exportPicture");
  waitIdle();
  EXPECT_FALSE(QImage(path("map.png")).isNull());
  chooseInNextDialog(path("map.vtp"));
  trigger("exportMap");
  waitIdle();
  EXPECT_EQ(readSurface(folder / "map.vtp").value.size(), bench->document.preop()->size());
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

TEST_F(DeformationPath, ASecondCaseStandsBesideTheFirstSeenFromTheSamePlace) {
  chooseInNextDialog(path("far"));
  click("compareWith");
  waitIdle();
  handleEvents(300);
  MapGalleryView* gallery = window->views().gallery();
  ASSERT_TRUE(gallery && gallery->isVisible()) << errors.join(" ").toStdString();
  ASSERT_EQ(gallery->scene().count(), 2);
  EXPECT_FALSE(window->view()->isVisible());
  keepPicture("deformation_cases");

  // The same place of both is read in its own tile; in the maps' frame, which is the scanner's.
  const Vector3d left = pose * Vector3d(radiusMm * 0.6, -radiusMm * 0.8, 0);
  QWidget* canvas = gallery->canvas();
  const QString near = hover(canvas, gallery->canvasPosition(0, left), "galleryProbe");
  const QString far = hover(canvas, gallery->canvasPosition(1, left), "galleryProbe");
  EXPECT_TRUE(near.startsWith("near")) << near.toStdString();
  EXPECT_TRUE(far.startsWith("far")) << far.toStdString();
  EXPECT_NEAR(distanceIn(near), 2, 0.6) << near.toStdString();
  EXPECT_NEAR(distanceIn(far), 5, 0.6) << far.toStdString();
  EXPECT_GE(bench->view.options().distanceColours.high, 5) << "one range that holds both";

  // A drag in one turns both.
  const auto offset = [&] {
    return QPoint(gallery->canvasPosition(1, left) - gallery->canvasPosition(0, left));
  };
  const QPoint first = gallery->canvasPosition(1, left), between = offset();
  const QPoint middle = gallery->canvasPosition(0, pose * Vector3d(0, -radiusMm, 0));
  dragIn(canvas, middle, middle + QPoint(40, 25));
  handleEvents(100);
  EXPECT_GT((gallery->canvasPosition(1, left) - first).manhattanLength(), 10) << "pixels";
  EXPECT_LE((offset() - between).manhattanLength(), 2) << "pixels; both moved alike";
  EXPECT_EQ(bench->view.options().enlargedCase, -1) << "a drag is no click";

  // A click shows one large, and the table its regions; Esc brings all back.
  QTest::mouseClick(canvas, Qt::LeftButton, {}, gallery->canvasPosition(1, left));
  handleEvents(200);
  EXPECT_EQ(bench->view.options().enlargedCase, 1);
  EXPECT_EQ(gallery->scene().enlarged().value_or(-1), 1);
  EXPECT_EQ(control<QTableWidget>("distanceStatistics").item(0, 0)->text(), "all");
  keepPicture("deformation_case_large");
  QTest::keyClick(canvas, Qt::Key_Escape);
  handleEvents(200);
  EXPECT_EQ(bench->view.options().enlargedCase, -1);
  EXPECT_EQ(control<QTableWidget>("distanceStatistics").item(1, 0)->text(), "far");

  chooseInNextDialog(path("both.png"));
  trigger("exportPicture");
  waitIdle();
  EXPECT_EQ(QImage(path("both.png")).size(), canvas->size() * canvas->devicePixelRatioF());
  window->showModule("Registration");
  handleEvents(100);
  EXPECT_TRUE(window->view()->isVisible());
  EXPECT_FALSE(gallery->isVisible());
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

}  // namespace
}  // namespace falciform::test
