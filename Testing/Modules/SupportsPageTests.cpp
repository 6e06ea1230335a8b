#include <gmock/gmock.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSlider>
#include <QTableWidget>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Core/Results.h"
#include "Modules/AtlasUpdate/SupportsPage.h"
#include "Testing/Modules/PanelFixture.h"

namespace falciform::test {
namespace {

using ::testing::HasSubstr;

std::shared_ptr<const Surface> liver() {
  static const auto made = [] {
    SyntheticLiverSettings shape;
    shape.edgeLengthMm = 5;
    return std::make_shared<const Surface>(makeSyntheticLiver(shape).surface);
  }();
  return made;
}

/// The model of this liver on coarse elements, made once: what the button makes, without the wait.
std::shared_ptr<const SupportModel> coarseModel() {
  static const auto made = [] {
    LiverModelSettings settings;
    settings.edgeLengthMm = 25;
    return prepareSupportModel(liver(), {}, nullptr, settings);
  }();
  return made;
}

struct SupportsPageTest : PanelTest {
  SupportsPage panel{bench};

  void openPrepared() {
    bench.document.setPreop(liver());
    ASSERT_TRUE(panel.logic().accept(coarseModel()));
    panel.enter();
  }
  [[nodiscard]] std::shared_ptr<const Surface> moved() const { return bench.view.options().liveDeformed; }
  [[nodiscard]] double largestMm() const {
    return moved() ? moved()->arrays.at(kDisplacement).maxCoeff() : 0;
  }
};

TEST_F(SupportsPageTest, SaysWhatIsMissingStepByStep) {
  panel.enter();
  EXPECT_FALSE(isEnabled(panel, "prepareModel"));
  EXPECT_THAT(words(panel, "missing"), HasSubstr("surface"));
  EXPECT_FALSE(isEnabled(panel, "paintSupport"));
  bench.document.setPreop(liver());
  EXPECT_TRUE(isEnabled(panel, "prepareModel"));
  EXPECT_THAT(words(panel, "modelFacts"), HasSubstr("No model yet"));
  EXPECT_TRUE(isEnabled(panel, "paintSupport")) << "painting needs no model";
  EXPECT_FALSE(isEnabled(panel, "fillTemplate"));
}

TEST_F(SupportsPageTest, TheButtonPreparesWithTheFormsSettings) {
  bench.document.setPreop(liver());
  panel.enter();
  child<QDoubleSpinBox>(panel, "edgeLengthMm").setValue(25);
  child<QDoubleSpinBox>(panel, "youngsModulusKPa").setValue(8);
  click(panel, "prepareModel");
  ASSERT_TRUE(panel.logic().model()) << errors.join(" ").toStdString();
  EXPECT_EQ(panel.logic().settings.youngsModulusKPa, 8);
  EXPECT_THAT(words(panel, "modelFacts"), HasSubstr("Ready"));
  EXPECT_TRUE(isEnabled(panel, "fillTemplate"));
  child<QDoubleSpinBox>(panel, "poissonsRatio").setValue(0.4);
  EXPECT_THAT(words(panel, "modelFacts"), HasSubstr("prepare it again"));
}

TEST_F(SupportsPageTest, ATemplateFillsThePaintingAndTheLiverMoves) {
  openPrepared();
  EXPECT_FALSE(moved());
  click(panel, "fillTemplate");
  ASSERT_TRUE(bench.document.supports());
  EXPECT_THAT(paintedSupports(*bench.document.supports()),
              testing::ElementsAre(support_label::kVenaCava, support_label::kPosteriorBed,
                                   support_label::kLeftPacking));
  ASSERT_TRUE(moved()) << words(panel, "liveMissing");
  EXPECT_GT(largestMm(), 15);
  EXPECT_THAT(words(panel, "deformationFigures"), HasSubstr("min det J"));
  EXPECT_GE(bench.view.options().displacementLimitMm, largestMm());
  click(panel, "undoSupport");
  EXPECT_TRUE(paintedSupports(*bench.document.supports()).empty());
  EXPECT_FALSE(moved());
  EXPECT_THAT(words(panel, "liveMissing"), HasSubstr("template"));
}

TEST_F(SupportsPageTest, TheSliderMovesTheLiverInProportion) {
  openPrepared();
  click(panel, "fillTemplate");
  const Points at20 = moved()->points - liver()->points;
  child<QSlider>(panel, "pushMmSlider").setValue(20);  // steps of 0.5 mm
  EXPECT_EQ(child<QDoubleSpinBox>(panel, "pushMm").value(), 10);
  EXPECT_EQ(bench.document.supports()->regions.at(support_label::kLeftPacking).pushMm, 10);
  const Points at10 = moved()->points - liver()->points;
  EXPECT_LT((at20 - 2 * at10).cwiseAbs().maxCoeff(), 1e-9);  // mm; the same fields, rounding only
  EXPECT_TRUE(bench.painting.canUndo()) << "the slider leaves the painter's steps alone";
}

TEST_F(SupportsPageTest, TurningThePatientMovesTheLiverToTheLeft) {
  openPrepared();
  auto& posture = child<QComboBox>(panel, "posture");
  posture.setCurrentIndex(static_cast<int>(SupportTemplate::TurnedLeft));
  Q_EMIT posture.activated(posture.currentIndex());
  click(panel, "fillTemplate");
  EXPECT_EQ(child<QDoubleSpinBox>(panel, "turnDeg").value(), kUsualTurnDeg);
  ASSERT_TRUE(moved());
  EXPECT_GT((moved()->points - liver()->points).col(0).mean(), 0);
  child<QSlider>(panel, "turnDegSlider").setValue(0);
  EXPECT_EQ(largestMm(), 0);
}

TEST_F(SupportsPageTest, AnotherKindIsAnotherAnswer) {
  openPrepared();
  click(panel, "fillTemplate");
  auto& kind = child<QComboBox>(panel, "kind_3");
  kind.setCurrentIndex(static_cast<int>(SupportRegionKind::Sliding));
  Q_EMIT kind.activated(kind.currentIndex());
  EXPECT_EQ(bench.document.supports()->regions.at(3).kind, SupportRegionKind::Sliding);
  EXPECT_FALSE(child<QSlider>(panel, "pushMmSlider").isEnabled()) << "nothing to push";
  EXPECT_EQ(largestMm(), 0);
}

TEST_F(SupportsPageTest, PaintsWhatIsChosenAndSaysWhatAHalfPaintedLiverLacks) {
  openPrepared();
  child<QTableWidget>(panel, "supportTable").setCurrentCell(0, 0);
  EXPECT_EQ(bench.painting.target, PaintTarget::Supports);
  EXPECT_EQ(bench.painting.label, support_label::kVenaCava);
  // All that looks back is painted, so that something is, and far more than was prepared for.
  std::vector<int> labels(static_cast<std::size_t>(liver()->size()), 0);
  for (Index i = 0; i < liver()->size(); ++i)
    if (liver()->points(i, 2) > 40) labels[static_cast<std::size_t>(i)] = support_label::kVenaCava;
  (void)bench.painting.replaceLabels(labels);
  EXPECT_THAT(words(panel, "liveMissing"), HasSubstr("prepare the model again"));
  click(panel, "eraseSupport");
  EXPECT_EQ(bench.painting.label, support_label::kFree);
  panel.addRegion("right kidney");
  EXPECT_EQ(bench.document.supports()->regions.at(5).name, "right kidney");
  EXPECT_EQ(bench.painting.label, 5);
}

TEST_F(SupportsPageTest, LeavingGivesBrushAndViewBack) {
  bench.painting.target = PaintTarget::Scan;
  bench.painting.label = patch::kInferiorRidge;
  openPrepared();
  click(panel, "fillTemplate");
  ASSERT_TRUE(moved());
  click(panel, "paintSupport");
  EXPECT_TRUE(bench.view.options().painting);
  panel.leave();
  EXPECT_FALSE(moved());
  EXPECT_FALSE(bench.view.options().painting || bench.view.options().supportsShown);
  EXPECT_EQ(bench.painting.target, PaintTarget::Scan);
  EXPECT_EQ(bench.painting.label, patch::kInferiorRidge);
  panel.enter();
  EXPECT_TRUE(moved()) << "what was painted is answered again";
}

TEST_F(SupportsPageTest, ALiverOfAnotherShapeDropsModelAndSupports) {
  openPrepared();
  click(panel, "fillTemplate");
  Surface other = *liver();
  other.points *= 1.1;
  bench.document.setPreop(std::make_shared<const Surface>(other));
  EXPECT_FALSE(panel.logic().model());
  EXPECT_FALSE(bench.document.supports());
  EXPECT_FALSE(moved());
}

}  // namespace
}  // namespace falciform::test
