#include <QLabel>
#include <QSlider>
#include <QTableWidget>
#include <QtTest/QTest>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Core/Results.h"
#include "Testing/Gui/WindowFixture.h"

namespace falciform::test {
namespace {

/// The built-in liver in the atlas module, on coarse elements so that the model is there in a second.
struct SupportsTest : WindowTest {
  void SetUp() override {
    WindowTest::SetUp();
    if (IsSkipped()) return;
    SyntheticLiverSettings shape;
    shape.edgeLengthMm = 4;
    liver = std::make_shared<const Surface>(makeSyntheticLiver(shape).surface);
    bench->document.setPreop(liver);
    window->showModule("AtlasUpdate");
    click("pageSupports");
    handleEvents(200);
  }
  void prepare() {
    type("edgeLengthMm", "22");
    click("prepareModel");
    waitIdle();
  }
  [[nodiscard]] std::shared_ptr<const Surface> moved() const { return bench->view.options().liveDeformed; }
  [[nodiscard]] double largestMm() const {
    return moved() ? moved()->arrays.at(kDisplacement).maxCoeff() : 0;
  }

  std::shared_ptr<const Surface> liver;
};

TEST_F(SupportsTest, AStrokeOfTheBrushIsASupport) {
  control<QTableWidget>("supportTable").setCurrentCell(2, 0);
  click("paintSupport");
  const Vector3d middle = liver->points.colwise().mean();
  // Across the right lobe, as the patient's front shows it.
  std::vector<QPoint> way;
  for (double x = -30; x <= 10; x += 10)
    way.push_back(window->view()->canvasPosition(middle + Vector3d(x, 0, 0)));
  drag(way);
  ASSERT_TRUE(bench->document.supports());
  EXPECT_EQ(paintedSupports(*bench->document.supports()), std::vector<int>{support_label::kLeftPacking});
  EXPECT_TRUE(patchLabels(*bench->document.preop()) == patchLabels(*liver)) << "patches are another layer";
  press(Qt::Key_Z);
  EXPECT_TRUE(paintedSupports(*bench->document.supports()).empty());
}

TEST_F(SupportsTest, TheLiverInTheViewFollowsTheSlider) {
  prepare();
  click("fillTemplate");
  waitUntil([&] { return moved() != nullptr; }, "the liver to move", 20);
  auto& slider = control<QSlider>("pushMmSlider");
  const double scale = slider.value() / 2.0;  // steps of 0.5 mm
  const double perMm = largestMm() / scale;
  // As fast as a hand drags: only the end counts, and it comes.
  for (int step = slider.value(); step <= 60; ++step) {
    slider.setValue(step);
    handleEvents(1);
  }
  waitUntil([&] { return std::abs(largestMm() - 30 * perMm) < 1e-6; }, "the last value to be shown", 20);
  EXPECT_TRUE(control<QLabel>("deformationFigures").text().contains("mm"));
  slider.setValue(0);
  waitUntil([&] { return moved() && largestMm() == 0; }, "the liver to come to rest", 20);
  window->showModule("PatchPainting");
  EXPECT_FALSE(moved()) << "other modules see the liver as it was imaged";
}

}  // namespace
}  // namespace falciform::test
