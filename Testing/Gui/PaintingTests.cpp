#include <QAbstractSpinBox>
#include <QLabel>
#include <QtTest/QTest>
#include <set>

#include "Testing/Gui/WindowFixture.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {
namespace {

constexpr double kRadiusMm = 50;

/// A sphere seen from the patient's front, painted by the mouse.
struct PaintingTest : WindowTest {
  void SetUp() override {
    WindowTest::SetUp();
    if (IsSkipped()) return;
    bench->document.setPreop(std::make_shared<const Surface>(sphere(kRadiusMm, 5)));
    window->showModule("PatchPainting");
    handleEvents(200);
  }
  /// On the front of the sphere, at height z.
  QPoint front(double x, double z) {
    return window->view()->canvasPosition({x, -std::sqrt(kRadiusMm * kRadiusMm - x * x - z * z), z});
  }
  std::vector<int> painted() { return pointsOfPatch(*bench->document.preop(), patch::kFalciform); }
  std::vector<QPoint> wayAcross() {
    std::vector<QPoint> way;
    for (double x = -20; x <= 20; x += 10) way.push_back(front(x, 0));
    return way;
  }
};

TEST_F(PaintingTest, ADragPaintsTheFrontAlongTheWayAndNothingElse) {
  click("paint");
  drag(wayAcross());
  const std::vector<int> ids = painted();
  ASSERT_GT(ids.size(), 50u);
  const double reach = bench->painting.radiusMm + 2;  // mm; the mesh's edges are 1.7 mm, a pixel about 0.2
  for (const int id : ids) {
    const Vector3d at = bench->document.preop()->points.row(id).transpose();
    EXPECT_LT(at.y(), 0) << "only what faces the viewer";
    EXPECT_LT(std::abs(at.z()), reach);
    EXPECT_LT(std::abs(at.x()), 20 + reach);
  }
  // Continuous although the mouse reported five positions: every vertex near the way is painted.
  const std::set<int> set(ids.begin(), ids.end());
  for (Index i = 0; i < bench->document.preop()->size(); ++i) {
    const Vector3d at = bench->document.preop()->points.row(i).transpose();
    if (at.y() < 0 && std::abs(at.z()) < 3 && std::abs(at.x()) < 18) {
      EXPECT_TRUE(set.count(static_cast<int>(i))) << at.transpose();
    }
  }
}

TEST_F(PaintingTest, WithoutPaintModeADragTurnsTheView) {
  const QPoint before = front(0, 20);
  drag(wayAcross());
  EXPECT_TRUE(painted().empty());
  EXPECT_NE(front(0, 20), before);
}

TEST_F(PaintingTest, KeysUndoRedoSizeAndLeave) {
  click("paint");
  drag(wayAcross());
  const std::vector<int> ids = painted();
  press(Qt::Key_Z);
  EXPECT_TRUE(painted().empty());
  press(Qt::Key_Y);
  EXPECT_EQ(painted(), ids);
  const double radius = bench->painting.radiusMm;
  press(Qt::Key_Plus);
  EXPECT_NEAR(bench->painting.radiusMm, 1.2 * radius, 1e-9);
  EXPECT_NEAR(control<QAbstractSpinBox>("brushRadius").property("value").toDouble(), 1.2 * radius, 1e-6);
  press(Qt::Key_2);
  EXPECT_EQ(bench->painting.label, patch::kInferiorRidge);
  press(Qt::Key_Escape);
  EXPECT_FALSE(bench->view.options().painting);
  drag(wayAcross());
  EXPECT_EQ(painted(), ids) << "Esc has left painting";
}

TEST_F(PaintingTest, UndoInThePanelTakesTheStrokeBack) {
  click("paint");
  drag(wayAcross());
  ASSERT_FALSE(painted().empty());
  click("undo");
  EXPECT_TRUE(painted().empty());
}

TEST_F(PaintingTest, LeavingTheModuleEndsPainting) {
  click("paint");
  window->showModule("Registration");
  EXPECT_FALSE(bench->view.options().painting);
}

TEST_F(PaintingTest, TheProbeTellsVertexPatchAndPlace) {
  click("paint");
  drag(wayAcross());
  press(Qt::Key_Escape);
  QTest::mouseMove(window->view()->canvas(), front(0, 0));
  waitUntil([&] { return control<QLabel>("probe").text().contains("falciform"); },
            "the probe to name the patch", 5);
  const QString text = control<QLabel>("probe").text();
  EXPECT_TRUE(text.startsWith("Pre-op liver")) << text.toStdString();
  EXPECT_TRUE(text.contains("vertex")) << text.toStdString();
  EXPECT_TRUE(text.contains("mm LPS")) << text.toStdString();
}

TEST_F(PaintingTest, StandardViewKeysTurnTheCamera) {
  const QPoint right = window->view()->canvasPosition({-kRadiusMm, 0, 0});
  QTest::keyClick(window->view()->canvas(), 'P', Qt::ShiftModifier);
  handleEvents();
  const QPoint mirrored = window->view()->canvasPosition({-kRadiusMm, 0, 0});
  const int middle = window->view()->canvas()->width() / 2;
  EXPECT_LT(right.x(), middle) << "from the front, the patient's right is on the left";
  EXPECT_GT(mirrored.x(), middle) << "from the back it is on the right";
}

}  // namespace
}  // namespace falciform::test
