#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "Logic/Patches/PatchPaintingLogic.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

/// A plane with a patch 1 left of x = 10 and a patch 2 right of x = 30.
struct PaintModes : testing::Test {
  PaintModes() {
    Surface plane = test::grid(40, 40);
    plane.patch.assign(static_cast<std::size_t>(plane.size()), 0);
    for (Index i = 0; i < plane.size(); ++i)
      plane.patch[static_cast<std::size_t>(i)] = plane.points(i, 0) < 10   ? 1
                                                 : plane.points(i, 0) > 30 ? 2
                                                                           : 0;
    document.setPreop(std::make_shared<const Surface>(std::move(plane)));
    before = document.preop()->patch;
    logic.radiusMm = 60;
  }
  /// One dab that covers everything.
  PatchEdit paintAll(int label) {
    logic.label = label;
    logic.beginStroke();
    (void)logic.dab(0, document.preop()->points.row(0).transpose());
    return logic.endStroke();
  }
  [[nodiscard]] std::vector<int> now() const { return document.preop()->patch; }

  Case document;
  PatchPaintingLogic logic{document};
  std::vector<int> before;
};

TEST_F(PaintModes, AddingLeavesOtherPatchesAloneReplacingDoesNot) {
  (void)paintAll(1);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(now()[i], before[i] == 2 ? 2 : 1);
  (void)logic.undo();
  EXPECT_EQ(now(), before);
  logic.replaces = true;
  (void)paintAll(1);
  EXPECT_THAT(now(), testing::Each(1));
  (void)logic.undo();
  EXPECT_EQ(now(), before);
}

TEST_F(PaintModes, ErasingTakesAnyPatch) {
  (void)paintAll(patch::kNone);
  EXPECT_THAT(now(), testing::Each(0));
}

TEST_F(PaintModes, ALockedPatchIsNeverChangedWhateverIsDone) {
  logic.setLocked(2, true);
  logic.replaces = true;
  const auto untouched = [&] {
    for (std::size_t i = 0; i < before.size(); ++i)
      if ((now()[i] == 2) != (before[i] == 2)) return false;
    return true;
  };
  std::mt19937 random(8);
  for (int step = 0; step < 200; ++step) {
    const int label = static_cast<int>(random() % 4);
    switch (random() % 7) {
      case 0:
        (void)paintAll(label);
        break;
      case 1:
        (void)logic.undo();
        break;
      case 2:
        (void)logic.redo();
        break;
      case 3:
        (void)logic.clearPatch(label);
        break;
      case 4:
        (void)logic.replaceLabels(std::vector<int>(before.size(), label));
        break;
      case 5:
        (void)logic.apply(grownPatch(*logic.surface(), logic.labels(), label, 5), label);
        break;
      default:
        (void)logic.apply(shrunkPatch(*logic.surface(), logic.labels(), label, 5), label);
    }
    ASSERT_TRUE(untouched()) << step;
  }
  logic.setLocked(2, false);
  (void)paintAll(3);
  EXPECT_FALSE(untouched());
}

TEST_F(PaintModes, AStepThatTouchedAPatchIsNotUndoneWhileItIsLocked) {
  (void)paintAll(1);
  logic.setLocked(1, true);
  EXPECT_FALSE(logic.canUndo());
  EXPECT_TRUE(logic.undo().empty());
  EXPECT_NE(logic.refusal(), "") << "and the brush says why it does not paint";
  logic.label = 3;
  EXPECT_EQ(logic.refusal(), "");
  logic.setLocked(1, false);
  EXPECT_TRUE(logic.canUndo());
  (void)logic.undo();
  EXPECT_EQ(now(), before);
}

TEST_F(PaintModes, PaintedIdsAndOperationsAreOneStepEach) {
  logic.label = 3;
  const PatchEdit edit = logic.paint({0, 15, 20, 39});  // x = 0, 15, 20, 39
  EXPECT_EQ(edit.ids, (std::vector<int>{15, 20})) << "adding leaves the other patches";
  (void)logic.apply({{0, 21}, {15}}, 3);
  EXPECT_EQ(now()[21], 3);
  EXPECT_EQ(now()[15], 0);
  EXPECT_EQ(now()[0], 1);
  (void)logic.undo();
  (void)logic.undo();
  EXPECT_EQ(now(), before);
  EXPECT_FALSE(logic.canUndo());
}

TEST_F(PaintModes, SupportsKnowNeitherLocksNorOtherPatches) {
  logic.target = PaintTarget::Supports;
  logic.setLocked(1, true);
  logic.setLocked(2, true);
  EXPECT_FALSE(paintAll(1).empty());
  EXPECT_EQ(paintAll(2).ids.size(), before.size());
}

}  // namespace
}  // namespace falciform
