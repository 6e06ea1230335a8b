#include <gtest/gtest.h>

#include <QImage>
#include <QSignalSpy>
#include <QtTest/QTest>
#include <limits>

#include "Widgets/Views/RangeHistogram.h"

namespace falciform::test {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// 100 values at 1.1, 300 at -2.1, 50 not covered; colours to 4 either side.
struct RangeHistogramTest : testing::Test {
  RangeHistogramTest() {
    histogram.resize(400, 160);
    VectorXd values(450);
    values << VectorXd::Constant(100, 1.1), VectorXd::Constant(300, -2.1), VectorXd::Constant(50, kNoValue);
    histogram.setValues(values, 4);
    histogram.setColours({"d", "Distance", "mm", -4, 4});
    QObject::connect(&histogram, &RangeHistogram::limitsChanged, [this](double l, double h) {
      low = l;
      high = h;
      ++told;
    });
  }
  [[nodiscard]] QPoint handle(double value) const {
    return {static_cast<int>(std::lround(histogram.positionOf(value))), 60};
  }
  /// A pixel at either end of a drag, and half a step.
  [[nodiscard]] double tolerance() const { return 3 * (histogram.valueAt(1) - histogram.valueAt(0)); }
  void drag(double from, double to) {
    QTest::mousePress(&histogram, Qt::LeftButton, {}, handle(from));
    QMouseEvent move(QEvent::MouseMove, handle(to), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&histogram, &move);
    QTest::mouseRelease(&histogram, Qt::LeftButton, {}, handle(to));
  }

  RangeHistogram histogram;
  double low = 0, high = 0;
  int told = 0;
};

TEST_F(RangeHistogramTest, DraggingALimitMovesBothWhileSymmetric) {
  drag(4, 2.5);
  EXPECT_NEAR(high, 2.5, tolerance());
  EXPECT_EQ(low, -high);
  drag(low, -3);
  EXPECT_NEAR(high, 3, tolerance());
}

TEST_F(RangeHistogramTest, LimitsGoTheirOwnWayIfNotSymmetricAndNeverCross) {
  histogram.setSymmetric(false);
  drag(4, 1);
  EXPECT_NEAR(high, 1, tolerance());
  EXPECT_EQ(low, -4);
  drag(-4, 3);
  EXPECT_LT(low, high);
}

TEST_F(RangeHistogramTest, ADragBesideTheHandlesMovesNothing) {
  drag(0, 2);
  EXPECT_EQ(told, 0);
}

TEST_F(RangeHistogramTest, TheKeyboardMovesTheMarkedLimit) {
  histogram.setSymmetric(false);
  QTest::keyClick(&histogram, Qt::Key_Left);
  EXPECT_LT(high, 4);
  EXPECT_EQ(low, -4);
  const double first = high;
  QTest::keyClick(&histogram, Qt::Key_Left);
  const double step = first - high;
  EXPECT_GT(step, 0);
  QTest::keyClick(&histogram, Qt::Key_Space);
  EXPECT_EQ(histogram.marked(), RangeHistogram::Limit::Low);
  QTest::keyClick(&histogram, Qt::Key_PageUp);
  EXPECT_NEAR(low, -4 + 10 * step, 0.51 * step) << "ten steps, to the nearest of all steps";
  QSignalSpy automatic(&histogram, &RangeHistogram::automaticWanted);
  QTest::keyClick(&histogram, Qt::Key_Home);
  EXPECT_EQ(automatic.count(), 1);
}

TEST_F(RangeHistogramTest, ABarTellsItsNumberAndUncoveredPlacesAreInNone) {
  const QString ones = histogram.barText(histogram.positionOf(1.1));
  EXPECT_TRUE(ones.contains("100 places (25.0 %)")) << ones.toStdString();
  EXPECT_TRUE(ones.contains("mm"));
  const QString twos = histogram.barText(histogram.positionOf(-2.1));
  EXPECT_TRUE(twos.contains("300 places (75.0 %)")) << twos.toStdString();
}

TEST_F(RangeHistogramTest, FarValuesAreCountedAtTheEdgeAndDoNotStretchTheAxis) {
  VectorXd values(3);
  values << 1, 2, 1000;
  histogram.setValues(values, 4);
  const double end = histogram.valueAt(histogram.width());
  EXPECT_LT(end, 10) << "mm";
  EXPECT_TRUE(histogram.barText(histogram.positionOf(8) - 3).contains("and more: 1 places"))
      << histogram.barText(histogram.positionOf(8) - 3).toStdString();
}

TEST_F(RangeHistogramTest, BarsHaveTheMapsColours) {
  const QImage image = histogram.grab().toImage();
  const auto inBar = [&](double value) {
    const Vector3d colour = colourOf({"d", "Distance", "mm", histogram.low(), histogram.high()}, value);
    const QColor seen = image.pixelColor(
        static_cast<int>(std::lround(histogram.positionOf(value) * image.devicePixelRatioF())),
        static_cast<int>(115 * image.devicePixelRatioF()));
    return Vector3d(seen.redF() - colour.x(), seen.greenF() - colour.y(), seen.blueF() - colour.z())
        .cwiseAbs()
        .maxCoeff();
  };
  // The bar has the colour of its middle, at most half a bin from the value.
  EXPECT_LT(inBar(-2.1), 0.06);
  EXPECT_LT(inBar(1.1), 0.06);
}

}  // namespace
}  // namespace falciform::test
