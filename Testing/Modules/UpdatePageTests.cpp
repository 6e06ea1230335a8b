#include <gmock/gmock.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSlider>
#include <QTableWidget>

#include "Modules/AtlasUpdate/UpdatePage.h"
#include "Testing/Modules/PanelFixture.h"
#include "Testing/Support/LiftedLiver.h"

namespace falciform::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The page on a liver whose left end was lifted by 10 mm; the model made once, on coarse elements.
struct UpdatePageTest : PanelTest {
  UpdatePage panel{bench};
  static constexpr double kLiftMm = 10;

  UpdatePageTest() {
    child<QDoubleSpinBox>(panel, "edgeLengthMm").setValue(25);
    panel.logic().settings.samplePoints = 400;
  }
  void fill() { fillLifted(bench.document, kLiftMm, scanFromPreop); }
  void prepare() {
    static ModelUpdateLogic::Model made;
    if (!made) {
      click(panel, "prepareUpdate");
      made = panel.logic().model();
    } else {
      ASSERT_TRUE(panel.logic().acceptModel(made));
      Q_EMIT bench.runner.finished();
    }
    ASSERT_TRUE(made) << errors.join(" ").toStdString();
  }
  void openUpdated() {
    fill();
    panel.enter();
    prepare();
    click(panel, "updateModel");
    ASSERT_TRUE(panel.maps()) << errors.join(" ").toStdString();
  }
  [[nodiscard]] const ViewOptions& options() const { return bench.view.options(); }
  void chooseColours(UpdateColours colours) {
    auto& box = child<QComboBox>(panel, "updateColours");
    box.setCurrentIndex(static_cast<int>(colours));
    Q_EMIT box.activated(box.currentIndex());
  }
  [[nodiscard]] double cell(int row, int column) {
    return child<QTableWidget>(panel, "targetTable").item(row, column)->text().toDouble();
  }
};

TEST_F(UpdatePageTest, SaysOneAfterTheOtherWhatIsMissing) {
  panel.enter();
  EXPECT_FALSE(isEnabled(panel, "prepareUpdate"));
  EXPECT_THAT(words(panel, "updateModelMissing"), HasSubstr("surface"));
  EXPECT_FALSE(isShown(panel, "updateModelFacts"));
  EXPECT_FALSE(isShown(panel, "targetTable"));
  EXPECT_THAT(words(panel, "confidence"), HasSubstr("Nothing has been updated"));
  bench.document.setPreop(std::make_shared<const Surface>(coarseLiver().surface));
  EXPECT_TRUE(isEnabled(panel, "prepareUpdate")) << "the model needs no scan";
  EXPECT_THAT(words(panel, "updateModelFacts"), HasSubstr("No model yet"));
  EXPECT_THAT(words(panel, "updateMissing"), HasSubstr("scan"));
  bench.document.setScan(std::make_shared<const Surface>(scanOfLifted(kLiftMm, scanFromPreop)));
  EXPECT_THAT(words(panel, "updateMissing"), HasSubstr("Register"));
  fill();
  EXPECT_THAT(words(panel, "updateMissing"), HasSubstr("Prepare the model"));
  EXPECT_TRUE(isShown(panel, "targetTable")) << "targets are listed before they are moved";
  prepare();
  EXPECT_THAT(words(panel, "updateModelFacts"), HasSubstr("Ready"));
  EXPECT_TRUE(isEnabled(panel, "updateModel"));
  EXPECT_FALSE(isShown(panel, "updateMissing"));
  for (const char* later : {"stopUpdate", "showRigid", "seeInside", "saveUpdated", "saveUpdatedTargets",
                            "saveUpdatePicture", "cancelPrepare"})
    EXPECT_FALSE(isEnabled(panel, later)) << later;
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

TEST_F(UpdatePageTest, AnOutdatedRegistrationOrModelIsSaidSo) {
  fill();
  panel.enter();
  click(panel, "prepareUpdate");
  child<QDoubleSpinBox>(panel, "edgeLengthMm").setValue(30);
  EXPECT_THAT(words(panel, "updateModelFacts"), HasSubstr("prepare it again"));
  EXPECT_TRUE(isEnabled(panel, "updateModel")) << "with the model there is";
  bench.document.setScan(std::make_shared<const Surface>(scanOfLifted(3, scanFromPreop)));
  EXPECT_FALSE(isEnabled(panel, "updateModel"));
  EXPECT_THAT(words(panel, "updateMissing"), HasSubstr("register again"));
}

TEST_F(UpdatePageTest, TheUpdateFollowsTheLiftAndTellsItsFiguresAndHowFarToTrustThem) {
  openUpdated();
  const UpdatedCase& made = *panel.maps()->of;
  EXPECT_LT(panel.maps()->updatedResidualMm, 0.5 * panel.maps()->rigidResidualMm)
      << "a bend that the model can follow";
  EXPECT_THAT(words(panel, "updateFigures"), HasSubstr("min det J"));
  EXPECT_THAT(words(panel, "updateFigures"), HasSubstr("fit, not target error"));
  EXPECT_THAT(words(panel, "confidence"),
              HasSubstr("Expected error " + QString::number(made.expectedErrorMeanMm, 'f', 1).toStdString()));
  EXPECT_THAT(words(panel, "confidence"), HasSubstr("tumour 1"));
  EXPECT_FALSE(isShown(panel, "updateStale"));
  EXPECT_EQ(child<QSlider>(panel, "updateShareSlider").value(),
            child<QSlider>(panel, "updateShareSlider").maximum());
  EXPECT_TRUE(isEnabled(panel, "saveUpdated") && isEnabled(panel, "saveUpdatedTargets"));
}

TEST_F(UpdatePageTest, RigidAndUpdatedStandInTheSameFrameAndTheSliderGoesBetween) {
  openUpdated();
  EXPECT_EQ(options().liveDeformed, panel.maps()->updated);
  EXPECT_TRUE(options().updateShown);
  // Where the registration's pose puts the moved liver back into the CT's frame.
  const Points back = transformed(panel.maps()->of->surface->points, scanFromPreop.inverse());
  EXPECT_LT((panel.maps()->updated->points - back).cwiseAbs().maxCoeff(), 1e-9);  // mm; rounding only
  click(panel, "showRigid");
  EXPECT_EQ(options().liveDeformed->points, coarseLiver().surface.points);
  EXPECT_EQ(options().movedStructures.at("tumour 1")->points, coarseLiver().structures.at("tumour 1").points);
  child<QDoubleSpinBox>(panel, "updateShare").setValue(0.5);
  const Points half = (coarseLiver().surface.points + panel.maps()->updated->points) / 2;
  EXPECT_LT((options().liveDeformed->points - half).cwiseAbs().maxCoeff(), 1e-9);  // mm; rounding only
  EXPECT_THAT(options().deformedCaption, HasSubstr("On the way, 0.50"));
  click(panel, "showUpdated");
  EXPECT_EQ(options().liveDeformed, panel.maps()->updated);
}

TEST_F(UpdatePageTest, EachChoiceOfColoursHasAnArrayALegendInMmAndAMeaning) {
  openUpdated();
  for (const auto colours : {UpdateColours::Motion, UpdateColours::Residual, UpdateColours::ScanGain,
                             UpdateColours::ExpectedError}) {
    chooseColours(colours);
    ASSERT_TRUE(options().updateColours);
    EXPECT_TRUE(options().liveDeformed->arrays.contains(options().updateColours->array));
    EXPECT_EQ(options().updateColours->unit, "mm");
    EXPECT_GT(options().updateColours->high, options().updateColours->low);
    EXPECT_THAT(words(panel, "coloursMeaning"), HasSubstr("mm"));
  }
  EXPECT_THAT(words(panel, "coloursMeaning"), HasSubstr("not measured"));
  chooseColours(UpdateColours::Plain);
  EXPECT_FALSE(options().updateColours);
}

TEST_F(UpdatePageTest, ViewsAreComparedCutAndSeenThroughAsTicked) {
  openUpdated();
  EXPECT_FALSE(options().comparedLiver || options().slicesShown);
  EXPECT_TRUE(options().structuresBefore);
  child<QCheckBox>(panel, "compareViews").click();
  EXPECT_EQ(options().comparedLiver, panel.maps()->rigid);
  child<QCheckBox>(panel, "ctSlices").click();
  EXPECT_TRUE(options().slicesShown);
  child<QCheckBox>(panel, "structuresBefore").click();
  EXPECT_FALSE(options().structuresBefore);
  const double solid = bench.view.look(part::kPreop).opacity;
  child<QCheckBox>(panel, "seeInside").click();
  EXPECT_LT(bench.view.look(part::kPreop).opacity, solid);
  panel.leave();
  EXPECT_EQ(bench.view.look(part::kPreop).opacity, solid) << "the tree's opacity is given back";
  EXPECT_FALSE(options().updateShown || options().liveDeformed || options().comparedLiver ||
               options().slicesShown);
  panel.enter();
  EXPECT_EQ(options().liveDeformed, panel.maps()->updated) << "the result is still there";
}

TEST_F(UpdatePageTest, TargetsSayHowFarTheyMovedAndInTrialsHowFarTheyAreOff) {
  fill();
  panel.enter();
  auto& table = child<QTableWidget>(panel, "targetTable");
  const int targets = static_cast<int>(coarseLiver().targets.points.size());
  EXPECT_EQ(table.rowCount(), targets + static_cast<int>(coarseLiver().structures.size()));
  prepare();
  click(panel, "updateModel");
  ASSERT_TRUE(panel.maps());
  EXPECT_TRUE(table.isColumnHidden(3) && table.isColumnHidden(4)) << "no truth was given";
  bench.document.setTruthTargets(truthOfLifted(kLiftMm, scanFromPreop));
  click(panel, "updateModel");
  EXPECT_FALSE(table.isColumnHidden(3) || table.isColumnHidden(4));
  for (int row = 0; row < targets; ++row) {
    const UpdatedTarget& target = panel.maps()->of->targets[static_cast<std::size_t>(row)];
    EXPECT_EQ(table.item(row, 0)->text().toStdString(), target.name);
    // mm; figures have one decimal.
    EXPECT_NEAR(cell(row, 1), (target.now - target.rigid).norm(), 0.051);
    EXPECT_NEAR(cell(row, 2), target.expectedErrorMm, 0.051);
    EXPECT_NEAR(cell(row, 3), *target.trueErrorMm, 0.051);
    EXPECT_NEAR(cell(row, 4), *target.rigidErrorMm, 0.051);
  }
  EXPECT_THAT(words(panel, "confidence"), HasSubstr("True error"));
  EXPECT_THAT(table.item(0, 0)->toolTip().toStdString(), HasSubstr("as updated"));
}

TEST_F(UpdatePageTest, WhatIsOutdatedSaysWhyAndAnotherLiverDropsIt) {
  openUpdated();
  Surface painted = *bench.document.preop();
  painted.patch.assign(static_cast<std::size_t>(painted.size()), patch::kFalciform);
  bench.document.setPreop(std::make_shared<const Surface>(painted));
  EXPECT_TRUE(isShown(panel, "updateStale"));
  EXPECT_THAT(words(panel, "updateStale"), HasSubstr("painted"));
  painted.points *= 1.1;
  bench.document.setPreop(std::make_shared<const Surface>(painted));
  EXPECT_FALSE(panel.maps() || panel.logic().model());
  EXPECT_FALSE(options().updateShown || options().liveDeformed);
  EXPECT_THAT(words(panel, "confidence"), HasSubstr("Nothing has been updated"));
  EXPECT_FALSE(isEnabled(panel, "saveUpdated"));
  bench.document.clear();
  EXPECT_FALSE(isEnabled(panel, "prepareUpdate"));
  EXPECT_FALSE(isShown(panel, "targetTable"));
}

TEST_F(UpdatePageTest, ALiverWithNothingInItIsUpdatedAsWell) {
  bench.document.setPreop(std::make_shared<const Surface>(coarseLiver().surface));
  bench.document.setScan(std::make_shared<const Surface>(scanOfLifted(kLiftMm, scanFromPreop)));
  RegistrationResult registration;
  registration.scanFromPreop = scanFromPreop;
  bench.document.setRegistration(std::make_shared<const RegistrationResult>(registration));
  panel.enter();
  prepare();
  click(panel, "updateModel");
  ASSERT_TRUE(panel.maps());
  EXPECT_FALSE(isShown(panel, "targetTable"));
  EXPECT_TRUE(isEnabled(panel, "saveUpdated"));
  EXPECT_FALSE(isEnabled(panel, "saveUpdatedTargets")) << "there are none";
  EXPECT_THAT(words(panel, "confidence"), Not(HasSubstr("tumour")));
}

TEST_F(UpdatePageTest, WhatCannotBeMeshedIsAnErrorInWordsAndThePageGoesOn) {
  Surface open = coarseLiver().surface;
  open.triangles.conservativeResize(open.triangles.rows() - 400, 3);
  bench.document.setPreop(std::make_shared<const Surface>(open));
  panel.enter();
  click(panel, "prepareUpdate");
  ASSERT_EQ(errors.size(), 1);
  EXPECT_FALSE(panel.logic().model());
  EXPECT_FALSE(isEnabled(panel, "cancelPrepare"));
  errors.clear();
  fill();
  prepare();
  EXPECT_TRUE(isEnabled(panel, "updateModel"));
}

}  // namespace
}  // namespace falciform::test
