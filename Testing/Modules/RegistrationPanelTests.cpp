#include <gmock/gmock.h>

#include <QCheckBox>
#include <QComboBox>
#include <QRadioButton>
#include <QSpinBox>

#include "Modules/Registration/LiveHistory.h"
#include "Modules/Registration/RegistrationPanel.h"
#include "Modules/Registration/ResultTable.h"
#include "Testing/Modules/PanelFixture.h"

namespace falciform::test {
namespace {

struct RegistrationPanelTest : PanelTest {
  RegistrationPanel panel{bench};
  ResultTable& table = child<ResultTable>(panel, "registrationResult");
};

TEST_F(RegistrationPanelTest, SaysWhatIsMissingAtEachStage) {
  EXPECT_FALSE(isEnabled(panel, "register"));
  const std::string first = words(panel, "missing");
  Surface bare = lumpyBody(3);
  bare.patch.clear();
  bench.document.setPreop(std::make_shared<const Surface>(bare));
  const std::string second = words(panel, "missing");
  bench.document.setScan(std::make_shared<const Surface>(bare));
  const std::string third = words(panel, "missing");
  EXPECT_FALSE(isEnabled(panel, "register")) << "nothing is painted";
  EXPECT_TRUE(first != second && second != third && !third.empty());
  child<QComboBox>(panel, "method").setCurrentText("icp");
  EXPECT_TRUE(isEnabled(panel, "register")) << "icp needs no patches";
}

TEST_F(RegistrationPanelTest, RegisteringPutsTheTruePoseIntoTheCase) {
  openPreopAndScan();
  ASSERT_TRUE(isEnabled(panel, "register"));
  click(panel, "register");
  ASSERT_TRUE(bench.document.registration()) << errors.join(" ").toStdString();
  const Points& points = bench.document.preop()->points;
  const Points moved = transformed(points, bench.document.registration()->scanFromPreop);
  const double worst = (moved - bench.document.scan()->points).rowwise().norm().maxCoeff();
  EXPECT_LT(worst,
            0.01);  // mm; the scan is the body itself, moved: the minimum is exact, the stop rule 1e-3 mm
  EXPECT_FALSE(bench.runner.busy());
  EXPECT_FALSE(isEnabled(panel, "stop"));
}

TEST_F(RegistrationPanelTest, TheResultTableHasEveryFigureUnderTheHeadingFitNotTargetError) {
  openPreopAndScan();
  click(panel, "register");
  EXPECT_EQ(table.horizontalHeaderItem(0)->text(), "Fit, not target error");
  for (const char* name :
       {"RMS residual", "RMS residual, weighted", "RMS of falciform", "RMS of inferior ridge", "Coverage",
        "Rotation from the start", "Translation from the start", "Scan points", "Iterations",
        "Stopped because", "Basins"})
    EXPECT_FALSE(table.value(name).isEmpty()) << name;
  EXPECT_EQ(table.value("Scan points").remove(','), QString::number(bench.document.scan()->size()));
  EXPECT_TRUE(table.value("Coverage").startsWith("100"));
}

TEST_F(RegistrationPanelTest, RepaintingMarksTheResultStaleUntilItIsRegisteredAgain) {
  openPreopAndScan();
  EXPECT_FALSE(isShown(panel, "stale"));
  click(panel, "register");
  EXPECT_FALSE(isShown(panel, "stale"));
  bench.document.setPreop(std::make_shared<const Surface>(*bench.document.preop()));
  EXPECT_TRUE(isShown(panel, "stale"));
  click(panel, "register");
  EXPECT_FALSE(isShown(panel, "stale"));
}

TEST_F(RegistrationPanelTest, BeforeAndAfterAreTheViews) {
  openPreopAndScan();
  EXPECT_FALSE(isEnabled(panel, "showBefore")) << "nothing to compare yet";
  click(panel, "register");
  EXPECT_TRUE(bench.view.options().afterRegistration);
  click(panel, "showBefore");
  EXPECT_FALSE(bench.view.options().afterRegistration);
  bench.view.edit([](ViewOptions& options) { options.afterRegistration = true; });
  EXPECT_TRUE(child<QRadioButton>(panel, "showAfter").isChecked());
}

TEST_F(RegistrationPanelTest, APresetFillsTheFormAndAnEditMakesItOnesOwn) {
  auto& preset = child<QComboBox>(panel, "preset");
  preset.setCurrentText("thesis-clinical");
  Q_EMIT preset.textActivated("thesis-clinical");
  EXPECT_EQ(settingsToJson(panel.logic().settings), settingsToJson(registrationPreset("thesis-clinical")));
  EXPECT_DOUBLE_EQ(child<QDoubleSpinBox>(panel, "weightMax").value(), 3000);
  child<QSpinBox>(panel, "maxIterations").setValue(12);
  EXPECT_EQ(preset.currentText(), "(own settings)");
  EXPECT_EQ(panel.logic().settings.maxIterations, 12);
}

TEST_F(RegistrationPanelTest, ALandmarkStartNeedsThreeOnEachSide) {
  openPreopAndScan();
  child<QCheckBox>(panel, "startFromLandmarks").setChecked(true);
  EXPECT_FALSE(isEnabled(panel, "register"));
  Landmarks preop, scan;
  for (const int vertex : {0, 50, 200}) {
    const Vector3d at = bench.document.preop()->points.row(vertex).transpose();
    preop.points.push_back({"F" + std::to_string(vertex), at});
    scan.points.push_back({"F" + std::to_string(vertex), scanFromPreop * at});
  }
  bench.document.setPreopLandmarks(preop);
  EXPECT_FALSE(isEnabled(panel, "register"));
  bench.document.setScanLandmarks(scan);
  EXPECT_TRUE(isEnabled(panel, "register"));
  click(panel, "register");
  ASSERT_TRUE(bench.document.registration());
  EXPECT_LT(bench.document.registration()->rmsMm, 0.01);  // mm, the scan is the body itself
}

TEST_F(RegistrationPanelTest, AFailureLeavesTheCaseAsItWasAndSaysWhy) {
  openPreopAndScan();
  panel.logic().settings.patches = {9};
  click(panel, "register");
  EXPECT_FALSE(bench.document.registration());
  ASSERT_FALSE(errors.isEmpty());
  EXPECT_TRUE(errors.front().contains("9"));
  EXPECT_TRUE(isEnabled(panel, "register"));
  EXPECT_FALSE(isEnabled(panel, "stop"));
}

TEST_F(RegistrationPanelTest, AResultOfReplacedSurfacesIsDropped) {
  openPreopAndScan();
  // The scan is replaced while the job runs, by the job's first report.
  QObject::connect(&bench.runner, &JobRunner::progressed, &panel, [&] {
    if (bench.document.scan()->size() != 12)
      bench.document.setScan(std::make_shared<const Surface>(sphere(50, 0)));
  });
  click(panel, "register");
  EXPECT_FALSE(bench.document.registration());
  EXPECT_TRUE(logged.join(" ").contains("dropped"));
}

TEST(LiveHistory, ANewStartForgetsTheLastAndAStoppedResultKeepsTheLastPose) {
  const auto history = std::make_shared<LiveHistory>();
  const IterationObserver observe = LiveHistory::observerOf(history);
  IterationRecord record;
  for (const int iteration : {1, 2, 3, 1, 2}) {
    record.iteration = iteration;
    record.rmsMm = iteration;
    record.preopFromScan = randomMotion(static_cast<unsigned>(iteration));
    observe(record);
  }
  EXPECT_EQ(history->size(), 2u);
  const RegistrationResult kept = stoppedResult(history->records(), 10, 20);
  EXPECT_TRUE(kept.scanFromPreop.isApprox(randomMotion(2).inverse(), 1e-12));
  EXPECT_FALSE(kept.converged);
  EXPECT_TRUE(std::isnan(kept.coverage)) << "what was not computed is not claimed";
  EXPECT_EQ(kept.iterations, 2);
}

}  // namespace
}  // namespace falciform::test
