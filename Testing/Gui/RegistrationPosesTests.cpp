#include <QTableWidget>
#include <QtTest/QTest>
#include <cmath>
#include <ctime>

#include "Modules/Registration/RegistrationPanel.h"
#include "Testing/Gui/WindowFixture.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {
namespace {

/// A body and its scan, moved by a known motion, with the registration step on screen.
struct RegistrationPoses : WindowTest {
  void SetUp() override {
    WindowTest::SetUp();
    if (IsSkipped()) return;
    bench->document.setPreop(std::make_shared<const Surface>(lumpyBody(4)));
    bench->document.setScan(std::make_shared<const Surface>(transformed(lumpyBody(4), truth, "scanner")));
    window->showModule("Registration");
    handleEvents(200);
  }
  [[nodiscard]] Isometry3d shown() const { return Isometry3d(*bench->view.options().livePreopFromScan); }
  /// Where an arrow of the handles stands: outside of rings of 0.4 of the scan's reach.
  [[nodiscard]] Vector3d arrow(int axis) const {
    const Points& points = bench->document.scan()->points;
    const Vector3d middle = points.colwise().mean();
    const double reach = (points.rowwise() - middle.transpose()).rowwise().norm().maxCoeff();
    return shown() * middle + 1.3 * 0.4 * reach * Vector3d::Unit(axis);
  }
  Isometry3d truth = randomMotion(3, 50);
};

TEST_F(RegistrationPoses, ADragOnAnArrowMovesTheScanAndRegisterFromHereFindsItsPlace) {
  click("register");
  waitIdle();
  ASSERT_TRUE(bench->document.registration()) << errors.join(" ").toStdString();
  click("moveByHand");
  handleEvents(100);
  ASSERT_TRUE(bench->view.options().moving);
  const Isometry3d before = shown();
  const Vector3d from = arrow(0);
  std::vector<QPoint> way;
  for (double mm = 0; mm <= 8; mm += 1)
    way.push_back(window->view()->canvasPosition(from + Vector3d(mm, 0, 0)));
  drag(way);
  const Vector3d step = shown().translation() - before.translation();
  EXPECT_NEAR(step.x(), 8, 1) << "mm; a pixel is about 0.3 mm, and both ends are rounded to one";
  EXPECT_LT(std::hypot(step.y(), step.z()), 1e-9);
  press(Qt::Key_Up);
  EXPECT_NEAR((shown().translation() - before.translation() - step).norm(), 5, 1e-9) << "one step of 5 mm";
  press(Qt::Key_Escape);
  EXPECT_FALSE(bench->view.options().moving);
  click("registerFromHere");
  waitIdle();
  const Points moved =
      transformed(bench->document.preop()->points, bench->document.registration()->scanFromPreop);
  EXPECT_LT((moved - bench->document.scan()->points).rowwise().norm().maxCoeff(),
            0.05);  // mm; the minimum is exact, the finish stops at motions of 0.02 mm
  EXPECT_GT(bench->document.registration()->translationMm, 7) << "mm, against the hand's pose";
}

TEST_F(RegistrationPoses, AnotherPoseIsClickedLookedAtUsedAndLeftAgain) {
  click("register");
  waitIdle();
  RegistrationResult result = *bench->document.registration();
  result.basins = {{result.scanFromPreop, 0.01, 9}, {randomMotion(1, 60), 0.2, 3}};
  bench->document.setRegistration(std::make_shared<const RegistrationResult>(result));
  handleEvents();
  auto& table = control<QTableWidget>("basins");
  click("showAfter");
  const QRect row = table.visualItemRect(table.item(1, 0));
  QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, row.center());
  handleEvents();
  ASSERT_TRUE(bench->view.options().livePreopFromScan);
  EXPECT_TRUE(shown().isApprox(randomMotion(1, 60).inverse(), 1e-12));
  click("useBasin");
  waitIdle();
  EXPECT_TRUE(bench->document.registration()->scanFromPreop.isApprox(randomMotion(1, 60), 1e-12));
  click("backToBest");
  waitIdle();
  EXPECT_TRUE(bench->document.registration()->scanFromPreop.isApprox(result.scanFromPreop, 1e-12));
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

/// Processor time of this thread, ms: what a click takes from it, however busy the machine is.
double threadMs() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

TEST_F(RegistrationPoses, NoActionHoldsTheWindowLongerThanATenthOfASecond) {
  // 41,000 and 10,000 points: of the size of a real case.
  bench->document.setPreop(std::make_shared<const Surface>(lumpyBody(6)));
  bench->document.setScan(std::make_shared<const Surface>(transformed(lumpyBody(5), truth, "scanner")));
  handleEvents(100);
  for (const char* button : {"register", "showBefore", "showAfter", "replay", "moveByHand", "turnXPlus",
                             "shiftYMinus", "registerFromHere", "showBefore"}) {
    auto& found = control<QAbstractButton>(button);
    ASSERT_TRUE(found.isEnabled()) << button;
    const double began = threadMs();
    found.click();
    EXPECT_LT(threadMs() - began, 100) << "ms, " << button;
    RecordProperty(button, std::to_string(threadMs() - began));
    waitIdle();
  }
}

}  // namespace
}  // namespace falciform::test
