#include <gmock/gmock.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QSlider>
#include <QTableWidget>
#include <chrono>

#include "Modules/Registration/BasinTable.h"
#include "Modules/Registration/RegistrationPanel.h"
#include "Modules/Registration/ResultTable.h"
#include "Testing/Modules/PanelFixture.h"
#include "Widgets/Forms/NumberBox.h"

namespace falciform::test {
namespace {

/// The panel's poses beside the stored one: by hand, of landmarks, in replay, of other basins.
struct RegistrationPosesTest : PanelTest {
  RegistrationPosesTest() { openPreopAndScan(); }

  [[nodiscard]] std::optional<Isometry3d> shown() const {
    const auto& live = bench.view.options().livePreopFromScan;
    return live ? std::optional(Isometry3d(*live)) : std::nullopt;
  }
  [[nodiscard]] double worstMm() const {
    const Points moved =
        transformed(bench.document.preop()->points, bench.document.registration()->scanFromPreop);
    return (moved - bench.document.scan()->points).rowwise().norm().maxCoeff();
  }
  /// A registered case whose result knows two poses more.
  void registerWithThreePoses() {
    click(panel, "register");
    RegistrationResult result = *bench.document.registration();
    result.basins = {
        {result.scanFromPreop, 0.01, 9}, {randomMotion(1, 60), 0.2, 3}, {randomMotion(2), 0.3, 1}};
    bench.document.setRegistration(std::make_shared<const RegistrationResult>(result));
  }
  void setLandmarks(double errorMm) {
    Landmarks preop, scan;
    for (const int vertex : {0, 50, 200, 300}) {
      const Vector3d at = bench.document.preop()->points.row(vertex).transpose();
      preop.points.push_back({"F" + std::to_string(vertex), at});
      scan.points.push_back({"F" + std::to_string(vertex), scanFromPreop * at});
    }
    scan.points[2].position += Vector3d(errorMm, 0, 0);
    bench.document.setPreopLandmarks(preop);
    bench.document.setScanLandmarks(scan);
  }

  RegistrationPanel panel{bench};
  ResultTable& table = child<ResultTable>(panel, "registrationResult");
};

TEST_F(RegistrationPosesTest, ButtonsMoveTheScanByTheirSteps) {
  EXPECT_FALSE(isShown(panel, "registerFromHere")) << "nothing was placed yet";
  click(panel, "moveByHand");
  ASSERT_TRUE(shown());
  EXPECT_TRUE(bench.view.options().moving);
  EXPECT_TRUE(shown()->isApprox(Isometry3d::Identity(), 1e-12)) << "from where it is seen";
  child<NumberBox>(panel, "stepMm").setValue(2);
  child<NumberBox>(panel, "stepDeg").setValue(10);
  click(panel, "shiftXPlus");
  click(panel, "shiftZMinus");
  EXPECT_LT((shown()->translation() - Vector3d(2, 0, -2)).norm(), 1e-12);
  const Vector3d middle = bench.document.scan()->points.colwise().mean();
  const Vector3d before = *shown() * middle;
  click(panel, "turnYPlus");
  EXPECT_LT((*shown() * middle - before).norm(), 1e-9) << "it turns in its place";
  const Eigen::AngleAxisd turn(shown()->linear());
  EXPECT_NEAR(turn.angle(), 10 * EIGEN_PI / 180, 1e-9);
  EXPECT_NEAR(turn.axis().y(), 1, 1e-9);
  EXPECT_FALSE(bench.document.registration()) << "nothing is stored";
  EXPECT_DOUBLE_EQ(bench.view.options().moveStepMm, 2) << "the view's keys have the same step";
}

TEST_F(RegistrationPosesTest, TheViewsHandlesMoveTheSamePoseAndEscKeepsItAsTheStart) {
  click(panel, "moveByHand");
  const Isometry3d dragged = randomMotion(9, 30);
  bench.view.edit([&](ViewOptions& options) { options.livePreopFromScan = dragged.matrix(); });
  bench.view.edit([](ViewOptions& options) { options.moving = false; });  // Esc in the view
  EXPECT_FALSE(child<QAbstractButton>(panel, "moveByHand").isChecked());
  EXPECT_FALSE(shown());
  EXPECT_TRUE(bench.view.options().startPreopFromScan.isApprox(dragged.matrix(), 1e-12));
  click(panel, "resetHandPose");
  EXPECT_TRUE(bench.view.options().startPreopFromScan.isIdentity(1e-12));
  EXPECT_FALSE(isShown(panel, "registerFromHere"));
}

TEST_F(RegistrationPosesTest, RegisterFromHereBeginsAtTheHandsPoseAndNeedsNoPatches) {
  Surface bare = *bench.document.scan();
  bare.patch.clear();
  bench.document.setScan(std::make_shared<const Surface>(bare));
  EXPECT_FALSE(isEnabled(panel, "register"));
  click(panel, "moveByHand");
  Isometry3d near = scanFromPreop.inverse();
  near.translation() += Vector3d(3, -2, 1);
  bench.view.edit([&](ViewOptions& options) { options.livePreopFromScan = near.matrix(); });
  click(panel, "registerFromHere");
  ASSERT_TRUE(bench.document.registration()) << errors.join(" ").toStdString();
  EXPECT_LT(worstMm(), 0.05);  // mm; the minimum is exact, the finish stops at motions of 0.02 mm
  EXPECT_NEAR(bench.document.registration()->translationMm, std::sqrt(14.0), 0.05)
      << "against the hand's pose";
  EXPECT_FALSE(shown()) << "the result is shown, not the hand's pose";
}

TEST_F(RegistrationPosesTest, ANewScanForgetsTheHandsPoseAndRepaintingKeepsIt) {
  click(panel, "moveByHand");
  click(panel, "shiftXPlus");
  Surface repainted = *bench.document.scan();
  repainted.patch[0] = 3;
  bench.document.setScan(std::make_shared<const Surface>(repainted));
  EXPECT_TRUE(isShown(panel, "registerFromHere"));
  bench.document.setScan(std::make_shared<const Surface>(sphere(40, 2)));
  EXPECT_FALSE(isShown(panel, "registerFromHere"));
  EXPECT_FALSE(bench.view.options().moving);
}

TEST_F(RegistrationPosesTest, LandmarkErrorsFollowTheLandmarksWorstFirst) {
  auto& errorsByName = child<QTableWidget>(panel, "landmarkErrors");
  child<QCheckBox>(panel, "startFromLandmarks").setChecked(true);
  EXPECT_FALSE(words(panel, "landmarkFit").empty()) << "says what is missing";
  setLandmarks(6);
  ASSERT_EQ(errorsByName.rowCount(), 4);
  EXPECT_EQ(errorsByName.item(0, 0)->text(), "F200") << "the one that was displaced";
  for (int row = 1; row < 4; ++row)
    EXPECT_GE(errorsByName.item(row - 1, 1)->text().toDouble(), errorsByName.item(row, 1)->text().toDouble());
  EXPECT_GT(errorsByName.item(0, 1)->text().toDouble(), 1) << "mm, of 6 mm shared out among four";
  setLandmarks(0);
  EXPECT_LT(errorsByName.item(0, 1)->text().toDouble(), 0.005) << "live";
  const Isometry3d start(bench.view.options().startPreopFromScan);
  EXPECT_TRUE(start.isApprox(scanFromPreop.inverse(), 1e-9)) << "where a registration would begin";
}

TEST_F(RegistrationPosesTest, LandmarksOnALineAreRefusedInWords) {
  child<QCheckBox>(panel, "startFromLandmarks").setChecked(true);
  Landmarks line;
  for (const double x : {0.0, 10.0, 20.0}) line.points.push_back({"", {x, 0, 0}});
  bench.document.setPreopLandmarks(line);
  bench.document.setScanLandmarks(line);
  EXPECT_FALSE(isEnabled(panel, "register"));
  EXPECT_THAT(words(panel, "missing"), testing::HasSubstr("line"));
}

TEST_F(RegistrationPosesTest, TheReplayShowsThePoseOfEachIterationAndEndsAtTheResult) {
  EXPECT_FALSE(isShown(panel, "replay")) << "nothing to replay yet";
  click(panel, "register");
  ASSERT_TRUE(isShown(panel, "replay"));
  const auto& history = bench.document.registration()->history;
  auto& slider = child<QSlider>(panel, "replayIteration");
  ASSERT_EQ(slider.maximum(), static_cast<int>(history.size()));
  slider.setValue(1);
  ASSERT_TRUE(shown());
  EXPECT_TRUE(shown()->isApprox(history[0].preopFromScan, 1e-12));
  slider.setValue(0);
  EXPECT_TRUE(shown()->isApprox(Isometry3d::Identity(), 1e-12)) << "the start";
  slider.setValue(slider.maximum());
  EXPECT_FALSE(shown()) << "the result itself";
  click(panel, "replay");
  ASSERT_TRUE(shown());
  const auto began = std::chrono::steady_clock::now();
  while (shown() && std::chrono::steady_clock::now() - began < std::chrono::seconds(10))
    QApplication::processEvents(QEventLoop::AllEvents, 20);
  EXPECT_FALSE(shown()) << "it runs to its end by itself";
}

TEST_F(RegistrationPosesTest, AnotherPoseIsShownThenUsedWithItsOwnFiguresAndTheBestComesBack) {
  registerWithThreePoses();
  const auto best = bench.document.registration();
  auto& basins = child<BasinTable>(panel, "basins");
  ASSERT_EQ(basins.rowCount(), 3);
  EXPECT_FALSE(isShown(panel, "useBasin")) << "none is selected";
  EXPECT_FALSE(isShown(panel, "backToBest")) << "it is the best";
  EXPECT_EQ(basins.item(0, 3)->text(), "0.0");
  basins.selectRow(1);
  ASSERT_TRUE(shown());
  EXPECT_TRUE(shown()->isApprox(randomMotion(1, 60).inverse(), 1e-12));
  EXPECT_EQ(bench.document.registration(), best) << "looking changes nothing";
  click(panel, "useBasin");
  const auto used = bench.document.registration();
  ASSERT_NE(used, best) << errors.join(" ").toStdString();
  EXPECT_TRUE(used->scanFromPreop.isApprox(randomMotion(1, 60), 1e-12));
  EXPECT_GT(used->rmsMm, best->rmsMm + 1) << "mm: its own figures, of a wrong pose";
  EXPECT_THAT(used->warnings, testing::Contains(testing::HasSubstr("chosen by the user")));
  EXPECT_EQ(table.value("Expected target error"), "not known");
  EXPECT_EQ(basins.rowCount(), 3) << "the list stays as it was found";
  click(panel, "backToBest");
  EXPECT_EQ(bench.document.registration(), best);
  EXPECT_FALSE(isShown(panel, "backToBest"));
}

TEST_F(RegistrationPosesTest, OnePreviewEndsAnother) {
  registerWithThreePoses();
  auto& basins = child<BasinTable>(panel, "basins");
  basins.selectRow(2);
  click(panel, "moveByHand");
  EXPECT_TRUE(shown()->isApprox(randomMotion(2).inverse(), 1e-12))
      << "the hand takes it from where it is seen";
  EXPECT_TRUE(bench.view.options().moving);
  basins.selectRow(1);
  EXPECT_FALSE(bench.view.options().moving);
  EXPECT_FALSE(child<QAbstractButton>(panel, "moveByHand").isChecked());
  click(panel, "showAfter");
  EXPECT_FALSE(shown());
  basins.selectRow(1);
  panel.leave();
  EXPECT_FALSE(shown()) << "another step must not see a pose that is not stored";
}

TEST_F(RegistrationPosesTest, StopKeepsTheLastPoseAndItsFiguresFollow) {
  child<QComboBox>(panel, "method").setCurrentText("icp");
  panel.logic().settings.finish = RegistrationFinish::None;
  // Stopped by the first report after ten iterations.
  QObject::connect(&bench.runner, &JobRunner::progressed, &panel, [&](double fraction, const QString&) {
    if (bench.runner.title() == "Registering" && fraction > 0) bench.runner.cancel();
  });
  click(panel, "register");
  ASSERT_TRUE(bench.document.registration()) << logged.join(" ").toStdString();
  EXPECT_EQ(bench.document.registration()->stopReason, "stopped by the user");
  QApplication::processEvents();
  const auto& kept = *bench.document.registration();
  EXPECT_EQ(kept.stopReason, "stopped by the user");
  EXPECT_TRUE(std::isfinite(kept.coverage) && std::isfinite(kept.p95Mm) && std::isfinite(kept.rotationDeg));
  EXPECT_EQ(kept.patchRmsMm.size(), 2u) << "per patch";
  EXPECT_TRUE(kept.scanFromPreop.isApprox(kept.history.back().preopFromScan.inverse(), 1e-12));
  EXPECT_THAT(kept.warnings, testing::Contains(testing::HasSubstr("Stopped before the end")));
  EXPECT_NE(table.value("RMS of falciform"), QString::fromUtf8("–"));
}

TEST_F(RegistrationPosesTest, TheExpectedTargetErrorStandsUnderAHeadingOfItsOwnAndAtEachStructure) {
  bench.document.setStructure("tumour", std::make_shared<const Surface>(sphere(5, 1)));
  click(panel, "register");
  const auto& result = *bench.document.registration();
  ASSERT_TRUE(result.expectedTargetErrorMm);
  EXPECT_TRUE(table.value("Expected target error").endsWith(" mm"));
  const QString there = table.value(QString::fromUtf8("… at tumour"));
  EXPECT_NEAR(there.chopped(3).toDouble(), result.expectedTargetErrorMm(Vector3d::Zero()), 0.005)
      << "mm, two decimals; the sphere's middle is the origin";
  EXPECT_TRUE(table.toolTip().contains("targets"));
}

}  // namespace
}  // namespace falciform::test
