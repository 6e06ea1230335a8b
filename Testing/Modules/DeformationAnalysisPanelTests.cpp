#include <gmock/gmock.h>

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGuiApplication>
#include <QTableWidget>

#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Modules/DeformationAnalysis/DeformationAnalysisPanel.h"
#include "Testing/Modules/PanelFixture.h"
#include "Testing/Support/MappedSpheres.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

constexpr double kGapMm = 2;

/// Two spheres about one centre, the scan the larger: everywhere 2 mm outside. The pose is given, not
/// searched.
struct DeformationAnalysisPanelTest : PanelTest {
  void openSpheres() { fillSpheres(bench.document, kGapMm, scanFromPreop); }
  void computed() {
    openSpheres();
    click(panel, "compute");
  }
  [[nodiscard]] const ScalarMap& colours() const { return bench.view.options().distanceColours; }
  void setBox(const char* name, double value) { child<QDoubleSpinBox>(panel, name).setValue(value); }
  void setTick(const char* name, bool on) { child<QCheckBox>(panel, name).setChecked(on); }
  [[nodiscard]] QString cell(int row, int column) const {
    return table.item(row, column)->text().replace(QChar(0x2009), ' ');  // thin spaces
  }

  DeformationAnalysisPanel panel{bench};
  QTableWidget& table = child<QTableWidget>(panel, "distanceStatistics");
};

TEST_F(DeformationAnalysisPanelTest, WaitsForARegistrationAndSaysSo) {
  openSpheres();
  bench.document.setRegistration(nullptr);
  EXPECT_FALSE(isEnabled(panel, "compute"));
  EXPECT_FALSE(words(panel, "missing").empty());
  openSpheres();
  EXPECT_TRUE(isEnabled(panel, "compute"));
  EXPECT_FALSE(isEnabled(panel, "exportMenu")) << "nothing computed yet";
}

TEST_F(DeformationAnalysisPanelTest, SaysWhatTheSignMeans) {
  EXPECT_THAT(words(panel, "signMeaning"),
              testing::StartsWith("Positive: the scan lies outside the pre-operative surface"));
}

TEST_F(DeformationAnalysisPanelTest, ComputingPutsTheMapIntoTheCaseAndTheTableShowsTheGapOfEachRegion) {
  computed();
  ASSERT_TRUE(bench.document.distance()) << errors.join(" ").toStdString();
  // mm; both spheres are the same icosphere, so flat faces lie at most 50 (1 - cos 2 deg) = 0.03 mm inside
  EXPECT_NEAR(bench.document.distance()->scanAll.mean, kGapMm, 0.05);
  ASSERT_EQ(table.rowCount(), 2);
  EXPECT_EQ(cell(0, 0), "all");
  EXPECT_EQ(cell(1, 0), "falciform");
  for (int row = 0; row < 2; ++row) {
    EXPECT_EQ(cell(row, 1), "100 %") << "all is covered";
    for (const int column : {3, 5, 6}) EXPECT_NEAR(cell(row, column).toDouble(), kGapMm, 0.05) << row;
    EXPECT_NEAR(cell(row, 2).split(QString::fromUtf8(" ± ")).first().toDouble(), kGapMm, 0.05);
  }
}

TEST_F(DeformationAnalysisPanelTest, SegmentsOfTheLiverGetTheirRows) {
  openSpheres();
  Surface liver = *bench.document.preop();
  liver.arrays[kCouinaudSegment] =
      (liver.points.col(0).array() > 0).select(VectorXd::Constant(liver.size(), 4), 8);
  const auto registration = bench.document.registration();
  bench.document.setPreop(std::make_shared<const Surface>(liver));
  bench.document.setRegistration(registration);
  click(panel, "compute");
  ASSERT_EQ(table.rowCount(), 4);
  EXPECT_EQ(cell(2, 0), "segment IV");
  EXPECT_EQ(cell(3, 0), "segment VIII");
}

TEST_F(DeformationAnalysisPanelTest, AMapOfSegmentsIsOpenedAndForgottenWithItsLiver) {
  const TemporaryFolder folder;
  LabelMap segments;  // of the whole sphere: IV on the patient's left, VIII on the right
  segments.size = {56, 56, 56};
  segments.worldFromIndex.diagonal().head<3>().setConstant(2);
  segments.worldFromIndex.topRightCorner<3, 1>().setConstant(-55);
  segments.voxels.resize(static_cast<std::size_t>(segments.size.prod()));
  for (std::size_t i = 0; i < segments.voxels.size(); ++i) segments.voxels[i] = i % 56 < 28 ? 8 : 4;
  writeLabelMap(folder / "segments.nii.gz", segments, Overwrite::Refuse);
  openSpheres();
  panel.openSegments(QString::fromStdString((folder / "segments.nii.gz").string()));
  EXPECT_THAT(words(panel, "segmentsFile"), testing::HasSubstr("segments.nii.gz"));
  click(panel, "compute");
  ASSERT_EQ(table.rowCount(), 4) << errors.join(" ").toStdString();
  EXPECT_EQ(cell(2, 0), "segment IV");
  EXPECT_EQ(cell(3, 0), "segment VIII");
  const VectorXd found = valuesOf(*bench.document.distance(), kCouinaudSegment, false);
  for (Index i = 0; i < found.size(); ++i)
    if (const double x = bench.document.preop()->points(i, 0); std::abs(x) > 2) {  // mm, a voxel
      EXPECT_EQ(found[i], x > 0 ? 4 : 8) << x;
    }
  bench.document.clear();
  openSpheres();
  click(panel, "compute");
  EXPECT_EQ(table.rowCount(), 2) << "another liver's segments";
}

TEST_F(DeformationAnalysisPanelTest, TheScaleIsSymmetricAndAutomaticUntilSomebodyTypes) {
  computed();
  EXPECT_TRUE(bench.view.options().distanceShown);
  const double fitted = colours().high;
  EXPECT_EQ(fitted, 2) << "98 % of all places lie a little less than 2 mm outside; a round end";
  EXPECT_EQ(colours().low, -fitted);
  setBox("rangeHigh", 7.5);
  EXPECT_EQ(colours().high, 7.5);
  EXPECT_EQ(colours().low, -7.5);
  EXPECT_FALSE(child<QCheckBox>(panel, "rangeAutomatic").isChecked());
  setTick("rangeSymmetric", false);
  setBox("rangeLow", -1);
  EXPECT_EQ(colours().low, -1);
  EXPECT_EQ(colours().high, 7.5);
  setBox("rangeLow", 8);
  EXPECT_EQ(colours().low, -1) << "above the upper end: refused";
  EXPECT_EQ(child<QDoubleSpinBox>(panel, "rangeLow").value(), -1) << "and the box says so";
  setTick("rangeSymmetric", true);
  EXPECT_EQ(colours().low, -7.5);
  setTick("rangeAutomatic", true);
  EXPECT_EQ(colours().high, fitted);
}

TEST_F(DeformationAnalysisPanelTest, AThresholdGreysWhatIsSmaller) {
  computed();
  EXPECT_NE(colourOf(colours(), 1.9), kBelowThresholdColour);
  setBox("threshold", 1.95);
  EXPECT_EQ(colours().threshold, 1.95);
  EXPECT_EQ(colourOf(colours(), 1.9), kBelowThresholdColour);
  EXPECT_EQ(colourOf(colours(), -1.9), kBelowThresholdColour);
  EXPECT_NE(colourOf(colours(), 2.0), kBelowThresholdColour);
}

TEST_F(DeformationAnalysisPanelTest, EveryArrayOfTheResultCanBeShownInItsOwnUnitAndRange) {
  computed();
  auto& metric = child<QComboBox>(panel, "metric");
  QStringList names;
  for (int i = 0; i < metric.count(); ++i) names << metric.itemText(i);
  ASSERT_TRUE(names.contains("Liver: signed distance, mm")) << names.join("; ").toStdString();
  ASSERT_TRUE(names.contains("Scan: signed distance, mm"));
  ASSERT_TRUE(names.contains("Liver: mean-curvature difference, 1/mm"));
  metric.setCurrentText("Scan: signed distance, mm");
  EXPECT_TRUE(bench.view.options().distanceOnScan);
  metric.setCurrentText("Liver: mean-curvature difference, 1/mm");
  EXPECT_FALSE(bench.view.options().distanceOnScan);
  EXPECT_EQ(colours().array, kCurvatureDifference);
  EXPECT_EQ(colours().unit, "1/mm");
  // 1/52 - 1/50 per mm is -0.00077.
  EXPECT_LT(colours().high, 0.02);
  EXPECT_NEAR(cell(0, 3).toDouble(), 1.0 / 52 - 1.0 / 50, 1e-4) << "1/mm; the fit on flat triangles";
  EXPECT_TRUE(child<QDoubleSpinBox>(panel, "rangeHigh").text().endsWith("1/mm"));
  EXPECT_THAT(words(panel, "signMeaning"), testing::HasSubstr("more convex"));
}

TEST_F(DeformationAnalysisPanelTest, ANewScanDropsTheMapAndItsNumbers) {
  computed();
  ASSERT_GT(table.rowCount(), 0);
  bench.document.setScan(std::make_shared<const Surface>(*bench.document.scan()));
  EXPECT_FALSE(bench.document.distance());
  EXPECT_EQ(table.rowCount(), 0);
  EXPECT_FALSE(isEnabled(panel, "exportMenu"));
}

TEST_F(DeformationAnalysisPanelTest, ExportsTableAndMap) {
  const TemporaryFolder folder;
  computed();
  panel.exportTable(QString::fromStdString((folder / "distance.csv").string()));
  const std::string text = readTextFile(folder / "distance.csv");
  EXPECT_EQ(text.rfind("case,side,metric,unit,region,coverage,count,mean,", 0), 0u) << text.substr(0, 80);
  EXPECT_THAT(text, testing::HasSubstr("preop,signed_distance_mm,mm,falciform,1,"));
  EXPECT_THAT(text, testing::HasSubstr("scan,curvature_difference_per_mm,1/mm,all,"));
  panel.exportMap(QString::fromStdString((folder / "map.vtp").string()));
  const Surface map = readSurface(folder / "map.vtp").value;
  EXPECT_EQ(map.frame, "LPS");
  // mm; written in single precision. The map lies where the liver was before, not in the scanner's frame.
  EXPECT_LT((map.points - bench.document.preop()->points).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_NEAR(map.arrays.at(kSignedDistance).mean(), kGapMm, 0.05);
}

TEST_F(DeformationAnalysisPanelTest, TheTableIsCopiedAsASpreadsheetTakesIt) {
  computed();
  child<QAction>(panel, "copyTable").trigger();
  const QStringList lines = QGuiApplication::clipboard()->text().split('\n');
  ASSERT_GE(lines.size(), 3);
  EXPECT_EQ(lines[0].split('\t').first(), "Liver");
  EXPECT_EQ(lines[0].split('\t').size(), 7);
  EXPECT_EQ(lines[1].split('\t').first(), "all");
}

TEST_F(DeformationAnalysisPanelTest, SettingsReachTheComputation) {
  openSpheres();
  setBox("reachMm", 1);  // less than the gap: nothing is covered
  click(panel, "compute");
  ASSERT_TRUE(bench.document.distance());
  EXPECT_EQ(bench.document.distance()->coverage, 0);
  EXPECT_EQ(cell(0, 1), "0 %");
  EXPECT_EQ(cell(0, 2), QString::fromUtf8("–")) << "no value is no number";
}

}  // namespace
}  // namespace falciform::test
