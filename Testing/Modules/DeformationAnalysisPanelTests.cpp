#include <gmock/gmock.h>

#include <QDoubleSpinBox>
#include <QTableWidget>

#include "Logic/IO/OutputFile.h"
#include "Modules/DeformationAnalysis/DeformationAnalysisPanel.h"
#include "Testing/Modules/PanelFixture.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

constexpr double kGapMm = 2;

/// Two spheres about one centre, the scan the larger: everywhere 2 mm outside. The pose is given, not
/// searched.
struct DeformationAnalysisPanelTest : PanelTest {
  void openSpheres() {
    Surface inner = sphere(50, 4), outer = sphere(50 + kGapMm, 4);
    inner.patch.assign(static_cast<std::size_t>(inner.size()), patch::kNone);
    for (Index i = 0; i < inner.size(); ++i)
      if (inner.points(i, 2) > 30) inner.patch[static_cast<std::size_t>(i)] = patch::kFalciform;
    outer.patch = inner.patch;
    bench.document.setPreop(std::make_shared<const Surface>(inner));
    bench.document.setScan(std::make_shared<const Surface>(transformed(outer, scanFromPreop, "scanner")));
  }
  void registerTruly() {
    auto result = std::make_shared<RegistrationResult>();
    result->scanFromPreop = scanFromPreop;
    bench.document.setRegistration(result);
  }

  DeformationAnalysisPanel panel{bench};
  QTableWidget& table = child<QTableWidget>(panel, "distanceStatistics");
};

TEST_F(DeformationAnalysisPanelTest, WaitsForARegistrationAndSaysSo) {
  openSpheres();
  EXPECT_FALSE(isEnabled(panel, "compute"));
  EXPECT_FALSE(words(panel, "missing").empty());
  registerTruly();
  EXPECT_TRUE(isEnabled(panel, "compute"));
  EXPECT_FALSE(isEnabled(panel, "exportCsv")) << "nothing computed yet";
}

TEST_F(DeformationAnalysisPanelTest, SaysWhatTheSignMeans) {
  const std::string sentence = words(panel, "signMeaning");
  EXPECT_NE(sentence.find("Positive"), std::string::npos);
  EXPECT_NE(sentence.find("outside"), std::string::npos);
}

TEST_F(DeformationAnalysisPanelTest, ComputingPutsTheMapIntoTheCaseAndTheTableShowsTheGap) {
  openSpheres();
  registerTruly();
  click(panel, "compute");
  ASSERT_TRUE(bench.document.distance()) << errors.join(" ").toStdString();
  // mm; both spheres are the same icosphere, so flat faces lie at most 50 (1 - cos 2 deg) = 0.03 mm inside
  EXPECT_NEAR(bench.document.distance()->scanAll.mean, kGapMm, 0.05);
  ASSERT_EQ(table.rowCount(), 4);
  EXPECT_EQ(table.item(0, 0)->text(), "Liver, all");
  EXPECT_EQ(table.item(1, 0)->text(), "Liver, falciform");
  for (int row = 0; row < 4; ++row) {
    EXPECT_NEAR(table.item(row, 1)->text().toDouble(), kGapMm, 0.05) << row;
    EXPECT_EQ(table.item(row, 4)->text(), "100 %") << "all within 5 mm";
  }
  child<QDoubleSpinBox>(panel, "threshold").setValue(1);
  EXPECT_EQ(table.item(0, 4)->text(), "0 %");
}

TEST_F(DeformationAnalysisPanelTest, TheColourRangeFitsTheValuesAndIsTheViews) {
  openSpheres();
  registerTruly();
  click(panel, "compute");
  EXPECT_TRUE(bench.view.options().distanceShown);
  const double fitted = bench.view.options().distanceLimitMm;
  EXPECT_GE(fitted, kGapMm);
  EXPECT_LE(fitted, 2 * kGapMm);
  child<QDoubleSpinBox>(panel, "colourLimit").setValue(7.5);
  EXPECT_DOUBLE_EQ(bench.view.options().distanceLimitMm, 7.5);
  click(panel, "fitRange");
  EXPECT_DOUBLE_EQ(bench.view.options().distanceLimitMm, fitted);
  click(panel, "distanceOnScan");
  EXPECT_TRUE(bench.view.options().distanceOnScan);
}

TEST_F(DeformationAnalysisPanelTest, RepaintingDropsTheMapAndItsNumbers) {
  openSpheres();
  registerTruly();
  click(panel, "compute");
  ASSERT_GT(table.rowCount(), 0);
  bench.document.setScan(std::make_shared<const Surface>(*bench.document.scan()));
  EXPECT_FALSE(bench.document.distance());
  EXPECT_EQ(table.rowCount(), 0);
  EXPECT_FALSE(isEnabled(panel, "exportPng"));
}

TEST_F(DeformationAnalysisPanelTest, ExportsTheStatisticsAsCsv) {
  const TemporaryFolder folder;
  openSpheres();
  registerTruly();
  click(panel, "compute");
  panel.exportCsv(QString::fromStdString((folder / "distance.csv").string()));
  const std::string text = readTextFile(folder / "distance.csv");
  EXPECT_EQ(text.rfind("side,patch,count,mean_mm", 0), 0u) << text.substr(0, 80);
  EXPECT_GE(std::count(text.begin(), text.end(), '\n'), 5) << "a heading and four rows";
}

TEST_F(DeformationAnalysisPanelTest, SettingsReachTheComputation) {
  openSpheres();
  registerTruly();
  child<QDoubleSpinBox>(panel, "reachMm").setValue(1);  // less than the gap: nothing is covered
  click(panel, "compute");
  ASSERT_TRUE(bench.document.distance());
  EXPECT_EQ(bench.document.distance()->coverage, 0);
  EXPECT_EQ(table.item(0, 1)->text(), QString::fromUtf8("–")) << "no value is no number";
}

}  // namespace
}  // namespace falciform::test
