#include <gmock/gmock.h>

#include "Modules/AtlasUpdate/UpdatePage.h"
#include "Testing/Modules/PanelFixture.h"
#include "Testing/Support/LiftedLiver.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;

struct SavedUpdate : PanelTest {
  void SetUp() override {
    fillLifted(bench.document, 12, scanFromPreop);
    panel.logic().mesh.edgeLengthMm = 25;
    panel.enter();
    click(panel, "prepareUpdate");
    click(panel, "updateModel");
    ASSERT_TRUE(panel.maps()) << errors.join(" ").toStdString();
  }
  UpdatePage panel{bench};
  TemporaryFolder folder;
};

TEST_F(SavedUpdate, IsShownAgainWhenTheCaseIsOpened) {
  const std::string figures = words(panel, "updateFigures"), confidence = words(panel, "confidence");
  const auto maps = panel.maps();
  ASSERT_TRUE(bench.files.save(folder / "case"));
  EXPECT_FALSE(bench.document.modified()) << errors.join(" ").toStdString();

  Workbench other(JobRunner::Mode::Inline);
  UpdatePage page(other);
  ASSERT_TRUE(other.files.open(folder / "case", FileRole::Case));
  page.enter();
  ASSERT_TRUE(page.maps()) << "worked out when the page is looked at";
  EXPECT_EQ(words(page, "updateFigures"), figures);
  EXPECT_EQ(words(page, "confidence"), confidence);
  EXPECT_FALSE(isShown(page, "updateStale"));
  // mm: the file keeps points as they are; the pose has twelve digits and more.
  EXPECT_LT((page.maps()->updated->points - maps->updated->points).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_NEAR(page.maps()->updatedResidualMm, maps->updatedResidualMm, 1e-8);
  EXPECT_FALSE(other.document.modified()) << "looking changes nothing";
  EXPECT_TRUE(isEnabled(page, "saveUpdated"));

  other.document.setScan(std::make_shared<const Surface>(*other.document.scan()));
  EXPECT_THAT(words(page, "updateStale"), HasSubstr("again"));
}

TEST_F(SavedUpdate, TargetsMoveWithTheLiver) {
  const auto& moved = bench.view.options().movedTargets;
  ASSERT_TRUE(moved);
  const auto& targets = bench.document.targets().points;
  ASSERT_EQ(moved->rows(), static_cast<Index>(targets.size()));
  const Isometry3d back = scanFromPreop.inverse();
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Vector3d now = back * panel.maps()->of->targets[i].now;
    EXPECT_LT((moved->row(static_cast<Index>(i)).transpose() - now).norm(), 1e-9) << "mm; rounding only";
  }
  click(panel, "showRigid");
  EXPECT_LT((bench.view.options().movedTargets->row(0).transpose() - targets[0].position).norm(), 1e-9);
}

TEST_F(SavedUpdate, AnotherCaseTakesItAway) {
  bench.document.clear();
  EXPECT_FALSE(panel.maps() || panel.logic().result());
  EXPECT_FALSE(bench.view.options().updateShown);
}

}  // namespace
}  // namespace falciform::test
