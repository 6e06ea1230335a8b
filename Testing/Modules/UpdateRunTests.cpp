#include <gmock/gmock.h>

#include <QDoubleSpinBox>
#include <QtTest/QTest>

#include "Modules/AtlasUpdate/UpdatePage.h"
#include "Testing/Modules/PanelFixture.h"
#include "Testing/Support/LiftedLiver.h"

namespace falciform::test {
namespace {

using ::testing::HasSubstr;

/// The page as it works: jobs beside the window.
struct UpdateRunTest : testing::Test {
  Workbench bench;
  UpdatePage panel{bench};
  Isometry3d pose = randomMotion(7, 60);
  QStringList logged;

  UpdateRunTest() {
    QObject::connect(&bench.log, &Log::added, [this](Log::Level, const QString& text) { logged << text; });
    child<QDoubleSpinBox>(panel, "edgeLengthMm").setValue(25);
    panel.logic().settings.samplePoints = 400;
    fillLifted(bench.document, 10, pose);
    panel.enter();
  }
  void waitIdle() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !bench.runner.busy(); }, 60000));
    QTest::qWait(1);
  }
  void prepare() {
    click(panel, "prepareUpdate");
    waitIdle();
    ASSERT_TRUE(panel.logic().model());
  }
};

TEST_F(UpdateRunTest, PreparingIsCancelledAndNothingIsKept) {
  click(panel, "prepareUpdate");
  EXPECT_FALSE(isEnabled(panel, "prepareUpdate") || isEnabled(panel, "updateModel"));
  EXPECT_THAT(words(panel, "updateModelMissing"), HasSubstr("is running"));
  click(panel, "cancelPrepare");
  waitIdle();
  EXPECT_FALSE(panel.logic().model());
  EXPECT_FALSE(isEnabled(panel, "cancelPrepare"));
  EXPECT_TRUE(isEnabled(panel, "prepareUpdate"));
}

TEST_F(UpdateRunTest, TheLiverAndWhatIsInItMoveWhileTheUpdateSettles) {
  prepare();
  std::vector<std::string> captions;
  bool structuresMoved = true;
  const Connection watching = bench.view.changed.connect([&] {
    const ViewOptions& options = bench.view.options();
    if (!options.deformedCaption.starts_with("Settling") || !options.liveDeformed) return;
    if (captions.empty() || captions.back() != options.deformedCaption)
      captions.push_back(options.deformedCaption);
    structuresMoved &= options.movedStructures.size() == coarseLiver().structures.size();
    EXPECT_FALSE(options.updateColours) << "the scan is seen on it";
  });
  click(panel, "updateModel");
  EXPECT_TRUE(isEnabled(panel, "stopUpdate"));
  EXPECT_FALSE(isEnabled(panel, "showRigid"));
  waitIdle();
  ASSERT_TRUE(panel.maps());
  EXPECT_FALSE(captions.empty()) << "some iteration was seen: the last one is always shown";
  EXPECT_TRUE(structuresMoved);
  EXPECT_EQ(bench.view.options().liveDeformed, panel.maps()->updated);
  EXPECT_FALSE(isEnabled(panel, "stopUpdate"));
}

TEST_F(UpdateRunTest, StopKeepsWhatThereIs) {
  prepare();
  click(panel, "updateModel");
  click(panel, "stopUpdate");
  EXPECT_FALSE(isEnabled(panel, "stopUpdate")) << "once is enough";
  waitIdle();
  ASSERT_TRUE(panel.maps());
  EXPECT_EQ(panel.maps()->of->update.iterations, 1) << "it was asked before the first had ended";
  EXPECT_THAT(words(panel, "updateFigures"), HasSubstr("Stopped after 1 iteration"));
  EXPECT_TRUE(isShown(panel, "updateWarnings"));
}

TEST_F(UpdateRunTest, ACancelledUpdateLeavesTheOneBefore) {
  prepare();
  click(panel, "updateModel");
  waitIdle();
  const UpdateMaps* before = panel.maps();
  ASSERT_TRUE(before);
  click(panel, "updateModel");
  bench.runner.cancel();
  waitIdle();
  EXPECT_EQ(panel.maps(), before);
  EXPECT_EQ(bench.view.options().liveDeformed, before->updated);
  EXPECT_THAT(logged.last().toStdString(), HasSubstr("stands"));
}

TEST_F(UpdateRunTest, AScanThatIsReplacedMeanwhileMakesTheResultOutdatedNotWrong) {
  prepare();
  click(panel, "updateModel");
  bench.document.setScan(std::make_shared<const Surface>(scanOfLifted(2, pose)));
  waitIdle();
  ASSERT_TRUE(panel.maps());
  EXPECT_THAT(words(panel, "updateStale"), HasSubstr("another scan"));
}

TEST(UpdateWatch, ShowsTheShapeThatAnIterationWouldResultIn) {
  Case document;
  const Isometry3d pose = randomMotion(5, 30);
  fillLifted(document, 10, pose);
  ModelUpdateLogic logic(document);
  logic.mesh.edgeLengthMm = 25;
  ASSERT_TRUE(logic.acceptModel(logic.prepareModel()({})));
  UpdateWatch watch(document, logic.model());
  logic.observer = [&, note = watch.observer()](const UpdateStep& step) {
    if (step.iteration == 3) watch.stop();
    return note(step);
  };
  const UpdatedCase& made = logic.run();
  EXPECT_EQ(made.update.iterations, 3);
  const std::vector<UpdateRecord> records = watch.records();
  ASSERT_EQ(records.size(), 3u);
  EXPECT_GT(records.front().expectedMm, 0);
  EXPECT_TRUE(std::isnan(records[1].expectedMm)) << "reckoned every fourth time";
  const UpdateShape& last = *records.back().shape;
  // mm; two ways to the same place, rounding only.
  EXPECT_LT((transformed(last.liver, pose) - made.surface->points).cwiseAbs().maxCoeff(), 1e-6);
  for (const auto& [name, points] : last.structures)
    EXPECT_LT((transformed(points, pose) - made.structures.at(name)->points).cwiseAbs().maxCoeff(), 1e-6)
        << name;
}

}  // namespace
}  // namespace falciform::test
