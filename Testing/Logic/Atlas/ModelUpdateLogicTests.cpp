#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "Logic/Atlas/LoadFiles.h"
#include "Logic/Atlas/ModelUpdateLogic.h"
#include "Logic/Core/Errors.h"
#include "Testing/Support/LiftedLiver.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

const SyntheticLiver& liver() { return coarseLiver(); }

/// The logic on a liver, its scan and their registration; the model made once, on coarse elements.
struct ModelUpdateLogicTest : testing::Test {
  Case document;
  ModelUpdateLogic logic{document};
  Isometry3d pose = randomMotion(3, 40);

  ModelUpdateLogicTest() { logic.mesh.edgeLengthMm = 25; }
  void fill(double bendMm) { fillLifted(document, bendMm, pose); }
  void prepare() {
    static const ModelUpdateLogic::Model made = logic.prepareModel()({});
    ASSERT_TRUE(logic.acceptModel(made));
  }
};

TEST_F(ModelUpdateLogicTest, SaysOneAfterTheOtherWhatIsMissing) {
  EXPECT_THAT(logic.missingInput(), HasSubstr("pre-operative surface"));
  EXPECT_THROW((void)logic.prepareModel(), InputError);
  document.setPreop(std::make_shared<const Surface>(liver().surface));
  EXPECT_THAT(logic.missingForModel(), IsEmpty());
  EXPECT_THAT(logic.missingInput(), HasSubstr("scan"));
  document.setScan(std::make_shared<const Surface>(scanOfLifted(0, pose)));
  EXPECT_THAT(logic.missingInput(), HasSubstr("Register"));
  document.setRegistration(std::make_shared<const RegistrationResult>());
  EXPECT_THAT(logic.missingInput(), HasSubstr("Prepare"));
  EXPECT_THROW((void)logic.prepare(), InputError);
  prepare();
  EXPECT_THAT(logic.missingInput(), IsEmpty());
  document.setScan(std::make_shared<const Surface>(scanOfLifted(1, pose)));
  EXPECT_THAT(logic.missingInput(), HasSubstr("register again"));
}

TEST_F(ModelUpdateLogicTest, TheCaseMovesAsTheSameCallsOfLogicMoveIt) {
  fill(8);
  prepare();
  Landmarks truth = liver().targets;  // any places will do: what counts is that distances are to them
  for (Landmark& target : truth.points) target.position = pose * target.position + Vector3d(1, 2, -2);
  std::reverse(truth.points.begin(), truth.points.end());  // paired by name
  document.setTruthTargets(truth);
  const UpdatedCase& made = logic.run();

  const UpdateResult same = updateModel(*logic.model(), *document.scan(), pose);
  EXPECT_EQ(made.update.displacements, same.displacements);
  EXPECT_EQ(made.surface->points, scanFromPreop(*logic.model(), same, liver().surface.points));
  EXPECT_EQ(made.surface->frame, "scanner");
  EXPECT_EQ(made.structures.at("tumour 1")->points,
            scanFromPreop(*logic.model(), same, liver().structures.at("tumour 1").points));
  EXPECT_DOUBLE_EQ(made.expectedErrorMeanMm, made.surface->arrays.at(kExpectedError).mean());
  ASSERT_EQ(made.targets.size(), liver().targets.points.size() + liver().structures.size());
  for (std::size_t i = 0; i < liver().targets.points.size(); ++i) {
    const UpdatedTarget& target = made.targets[i];
    EXPECT_EQ(target.name, liver().targets.points[i].name);
    EXPECT_GT(target.expectedErrorMm, 0);
    ASSERT_TRUE(target.rigidErrorMm && target.trueErrorMm);
    EXPECT_NEAR(*target.rigidErrorMm, 3, 1e-9) << "mm; |(1, 2, -2)|, rounding only";
    EXPECT_NEAR((target.now - target.rigid - Vector3d(1, 2, -2)).norm(), *target.trueErrorMm, 1e-9);
  }
  EXPECT_TRUE(made.targets.back().structure);
  EXPECT_FALSE(made.targets.back().trueErrorMm);
}

TEST_F(ModelUpdateLogicTest, AnAtlasOfSurfaceLoadsIsTheModelItWasSolvedForAndAnotherLiversIsRefused) {
  fill(8);
  prepare();
  const TemporaryFolder folder;
  LoadAtlas atlas;
  atlas.design = atlasPreset("surface-loads");
  atlas.loads = logic.model()->responses();
  writeLoadAtlas(folder / "loads.h5", atlas, nlohmann::json::object());
  const UpdatedCase before = logic.run();
  ASSERT_TRUE(logic.acceptModel(logic.prepareModel(folder / "loads.h5")({})));
  EXPECT_FALSE(logic.modelOutdated()) << "no settings made it";
  const UpdatedCase& after = logic.run();
  EXPECT_LT((after.surface->points - before.surface->points).cwiseAbs().maxCoeff(),
            1e-6)  // mm; rounding only
      << "the file holds all there is";
  Surface other = liver().surface;
  other.points.rowwise() += Eigen::RowVector3d(150, 0, 0);
  document.setPreop(std::make_shared<const Surface>(other));
  EXPECT_THROW((void)logic.prepareModel(folder / "loads.h5")({}), InputError);
  EXPECT_THROW((void)logic.prepareModel(folder / "absent.h5")({}), InputError);
}

TEST_F(ModelUpdateLogicTest, AResultSaysWhyItIsStale) {
  fill(4);
  prepare();
  (void)logic.run();
  EXPECT_THAT(logic.staleReason(), IsEmpty());
  const double before = logic.settings.noiseFloorMm;
  logic.settings.noiseFloorMm = 1;
  EXPECT_THAT(logic.staleReason(), HasSubstr("Settings"));
  logic.settings.noiseFloorMm = before;
  EXPECT_THAT(logic.staleReason(), IsEmpty());
  document.setRegistration(std::make_shared<const RegistrationResult>(*document.registration()));
  EXPECT_THAT(logic.staleReason(), HasSubstr("registered"));
  Surface painted = *document.preop();
  painted.patch.assign(static_cast<std::size_t>(painted.size()), patch::kFalciform);
  document.setPreop(std::make_shared<const Surface>(painted));
  EXPECT_TRUE(logic.result()) << "the shape is the same";
  EXPECT_TRUE(logic.model());
  EXPECT_THAT(logic.staleReason(), HasSubstr("liver was painted"));
  document.setScan(std::make_shared<const Surface>(scanOfLifted(5, pose)));
  EXPECT_THAT(logic.staleReason(), HasSubstr("another scan"));
  painted.points(0, 0) += 1;
  document.setPreop(std::make_shared<const Surface>(painted));
  EXPECT_FALSE(logic.result() || logic.model()) << "of another liver";
}

TEST_F(ModelUpdateLogicTest, TheObserverSeesEveryIterationAndEndsTheUpdateWithWhatThereIs) {
  fill(8);
  prepare();
  std::vector<int> iterations;
  double lastRms = 0, keptRms = 0;
  UpdateResult kept;
  logic.observer = [&](const UpdateStep& step) {
    iterations.push_back(step.iteration);
    lastRms = step.rmsMm;
    if (step.iteration < 5) return true;
    kept = step.result();
    keptRms = kept.rmsMm;
    return false;
  };
  const UpdateResult& update = logic.run().update;
  EXPECT_EQ(iterations, (std::vector<int>{1, 2, 3, 4, 5}));
  EXPECT_EQ(keptRms, lastRms);
  EXPECT_EQ(update.iterations, 5);
  EXPECT_FALSE(update.converged);
  EXPECT_THAT(update.stopReason, HasSubstr("stopped by the user"));
  EXPECT_EQ(update.displacements, kept.displacements);
  EXPECT_FALSE(update.warnings.empty());
}

TEST_F(ModelUpdateLogicTest, UnequalNumbersOfTrueTargetsGiveAWarningAndNoError) {
  fill(0);
  prepare();
  Landmarks truth = liver().targets;
  truth.points.pop_back();
  document.setTruthTargets(truth);
  const UpdatedCase& made = logic.run();
  EXPECT_FALSE(made.targets.front().trueErrorMm);
  ASSERT_FALSE(made.update.warnings.empty());
  EXPECT_THAT(made.update.warnings.back(), HasSubstr("true positions"));
}

}  // namespace
}  // namespace falciform::test
