#include <gmock/gmock.h>

#include <QComboBox>
#include <QDoubleSpinBox>

#include "Modules/ScanPreparation/ScanPreparationPanel.h"
#include "Testing/Modules/PanelFixture.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;

/// A sheet of 100 x 100 mm: liver left of x = 60, gauze right of it; a falciform patch in the liver.
Surface twoTissues(double scale = 1) {
  Surface scan = grid(100, 100);
  scan.colours.resize(scan.size(), 3);
  scan.patch.assign(static_cast<std::size_t>(scan.size()), patch::kNone);
  for (Index i = 0; i < scan.size(); ++i) {
    const bool liver = scan.points(i, 0) < 60;
    scan.colours.row(i) << (liver ? 146 : 214), (liver ? 68 : 190), (liver ? 56 : 182);
    if (scan.points(i, 0) < 10) scan.patch[static_cast<std::size_t>(i)] = patch::kFalciform;
  }
  scan.points *= scale;
  scan.frame = "scanner";
  return scan;
}

struct ScanPreparationPanelTest : PanelTest {
  void open(Surface scan) { bench.document.setScan(std::make_shared<const Surface>(std::move(scan))); }
  [[nodiscard]] const Surface& scan() const { return *bench.document.scan(); }
  [[nodiscard]] Index pointsWith(int label) const {
    return static_cast<Index>(pointsOfPatch(scan(), label).size());
  }
  void paint(int label, const Vector3d& place, double radiusMm) {
    bench.painting.target = PaintTarget::Scan;
    bench.painting.label = label;
    bench.painting.radiusMm = radiusMm;
    const int triangle = nearestTriangle(place);
    bench.painting.beginStroke();
    (void)bench.painting.dab(triangle, place);
    (void)bench.painting.endStroke();
  }
  [[nodiscard]] int nearestTriangle(const Vector3d& place) const {
    int nearest = 0;
    double least = 1e30;
    for (Index t = 0; t < scan().triangles.rows(); ++t) {
      const double distance = (scan().points.row(scan().triangles(t, 0)).transpose() - place).norm();
      if (distance < least) {
        least = distance;
        nearest = static_cast<int>(t);
      }
    }
    return nearest;
  }
  static constexpr int kOther = scan_label::kFirst + static_cast<int>(ScanMark::OtherTissue);
  ScanPreparationPanel panel{bench};
};

TEST_F(ScanPreparationPanelTest, SaysWhatIsMissingInsteadOfADeadButton) {
  EXPECT_FALSE(isEnabled(panel, "markScan"));
  EXPECT_THAT(words(panel, "missing"), HasSubstr("Open a scan"));
  open(twoTissues());
  EXPECT_TRUE(isEnabled(panel, "markScan"));
  EXPECT_FALSE(isEnabled(panel, "applyScan"));
  EXPECT_FALSE(isEnabled(panel, "restoreScan"));
}

TEST_F(ScanPreparationPanelTest, MarksAreColoursOnTheScanAndNothingIsTakenOutYet) {
  open(twoTissues());
  click(panel, "markScan");
  EXPECT_EQ(scan().size(), 101 * 101);
  EXPECT_NEAR(static_cast<double>(pointsWith(kOther)), 40 * 101, 5 * 101);
  EXPECT_EQ(patchName(scan(), kOther), "goes: other tissue");
  EXPECT_THAT(words(panel, "markCounts"), HasSubstr("other tissue"));
  EXPECT_TRUE(isEnabled(panel, "applyScan"));
}

TEST_F(ScanPreparationPanelTest, ApplyTakesOutWhatIsMarkedAndRestoreBringsItBack) {
  const Surface raw = twoTissues();
  open(raw);
  click(panel, "markScan");
  const Index going = pointsWith(kOther);
  click(panel, "applyScan");
  EXPECT_EQ(scan().size(), raw.size() - going);
  EXPECT_EQ(patchLabels(scan()), std::vector<int>{patch::kFalciform}) << "marks are gone, patches are not";
  EXPECT_EQ(scan().frame, "scanner");
  EXPECT_FALSE(isEnabled(panel, "applyScan"));
  click(panel, "restoreScan");
  EXPECT_EQ(scan().points, raw.points);
  EXPECT_EQ(scan().patch, raw.patch);
  EXPECT_FALSE(isEnabled(panel, "restoreScan"));
}

TEST_F(ScanPreparationPanelTest, TheBrushMendsAndItsStrokesStandAgainstNewMarks) {
  open(twoTissues());
  click(panel, "markScan");
  paint(scan_label::kByHand, {30, 30, 0}, 5);
  paint(patch::kNone, {90, 50, 0}, 5);
  const Index byHand = pointsWith(scan_label::kByHand), other = pointsWith(kOther);
  EXPECT_GT(byHand, 50);
  child<QDoubleSpinBox>(panel, "colourLimit").setValue(3);  // marks anew
  EXPECT_EQ(pointsWith(scan_label::kByHand), byHand);
  EXPECT_NEAR(static_cast<double>(pointsWith(kOther)), static_cast<double>(other), 101);
  EXPECT_EQ(scan().patchAt(90 * 101 + 50) == kOther && scan().patchAt(50 * 101 + 90) == kOther, false);
  click(panel, "applyScan");
  EXPECT_GT((scan().points.rowwise() - Vector3d(30, 30, 0).transpose()).rowwise().norm().minCoeff(), 4);
}

TEST_F(ScanPreparationPanelTest, UndoTakesAStrokeBack) {
  open(twoTissues());
  click(panel, "markScan");
  const std::vector<int> before = scan().patch;
  paint(scan_label::kByHand, {30, 30, 0}, 5);
  EXPECT_NE(scan().patch, before);
  click(panel, "undoScan");
  EXPECT_EQ(scan().patch, before);
}

TEST_F(ScanPreparationPanelTest, ADabSaysWhereLiverIs) {
  open(twoTissues());
  paint(scan_label::kSeed, {85, 50, 0}, 4);  // the pale side, this once
  click(panel, "markScan");
  ASSERT_TRUE(panel.logic().marked());
  EXPECT_FALSE(panel.logic().marked()->automatic);
  EXPECT_NEAR(static_cast<double>(pointsWith(kOther)), 60 * 101, 5 * 101);
}

TEST_F(ScanPreparationPanelTest, MetresAreSaidBeforeAndScaledWhenMarked) {
  open(twoTissues(1e-3));
  EXPECT_THAT(words(panel, "unitWords"), HasSubstr("taken for m "));
  EXPECT_TRUE(isShown(panel, "unitWords"));
  click(panel, "markScan");
  EXPECT_NEAR(scan().points.maxCoeff(), 100, 1e-9);
  EXPECT_TRUE(isShown(panel, "warnings"));
}

TEST_F(ScanPreparationPanelTest, OtherStepsDoNotSeeTheMarks) {
  open(twoTissues());
  click(panel, "markScan");
  paint(scan_label::kByHand, {30, 30, 0}, 5);
  const std::vector<int> marked = scan().patch;
  panel.leave();
  EXPECT_EQ(patchLabels(scan()), std::vector<int>{patch::kFalciform});
  EXPECT_TRUE(scan().patchNames.empty());
  EXPECT_THAT(logged.join("\n").toStdString(), HasSubstr("still in it"));
  panel.enter();
  EXPECT_EQ(scan().patch, marked);
}

TEST_F(ScanPreparationPanelTest, AnotherScanBeginsAnew) {
  open(twoTissues());
  click(panel, "markScan");
  open(sphere(40, 3));
  EXPECT_FALSE(isEnabled(panel, "applyScan"));
  EXPECT_FALSE(isEnabled(panel, "restoreScan"));
  EXPECT_EQ(panel.logic().marked(), nullptr);
}

}  // namespace
}  // namespace falciform::test
