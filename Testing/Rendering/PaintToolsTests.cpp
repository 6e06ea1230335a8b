#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Testing/Rendering/PaintingView.h"
#include "Widgets/Rendering/PaintInteractor.h"

namespace falciform {

struct PaintTools : test::PaintingView {
  PaintTools() {
    style->onWarn = [this](const std::string& why) { warnings.push_back(why); };
  }
  void click(int x, int y) {
    move(x, y);
    press(x, y);
    release(x, y);
  }
  void enter() { key('\r', "Return"); }

  std::vector<std::string> warnings;
};

TEST_F(PaintTools, ALineIsPaintedFromClickToClickAtEnterInOneStep) {
  logic.tool = PaintTool::Line;
  logic.radiusMm = 6;
  startPainting();
  click(90, 80);
  click(230, 100);
  click(200, 170);
  EXPECT_TRUE(painted().empty()) << "until it is finished";
  enter();
  const Vector3d a = onPlane(90, 80), b = onPlane(230, 100), c = onPlane(200, 170);
  std::set<int> inner = within(5.8, a, b), outer = within(6.2, a, b);
  for (const int id : within(5.8, b, c)) inner.insert(id);
  for (const int id : within(6.2, b, c)) outer.insert(id);
  EXPECT_THAT(inner, testing::IsSubsetOf(painted()));
  EXPECT_THAT(painted(), testing::IsSubsetOf(outer));
  key('z', "z");
  EXPECT_TRUE(painted().empty()) << "one step";
  EXPECT_FALSE(logic.canUndo());
}

TEST_F(PaintTools, BackspaceTakesTheLastCornerBackAndEscDropsTheLineBeforeItLeaves) {
  logic.tool = PaintTool::Line;
  startPainting();
  click(90, 80);
  click(230, 80);
  click(230, 170);
  key('\b', "BackSpace");
  enter();
  const std::set<int> straight = painted();
  EXPECT_THAT(straight, testing::IsSubsetOf(within(6.2, onPlane(90, 80), onPlane(230, 80))));
  click(90, 170);
  click(230, 170);
  key(27, "Escape");
  EXPECT_TRUE(style->painting());
  enter();
  EXPECT_EQ(painted(), straight) << "what was dropped is not painted";
  key(27, "Escape");
  EXPECT_FALSE(style->painting());
}

TEST_F(PaintTools, ADoubleClickFinishesTheLine) {
  logic.tool = PaintTool::Line;
  startPainting();
  click(90, 80);
  click(230, 80);
  event(vtkCommand::LeftButtonDoubleClickEvent, 230, 80);
  EXPECT_FALSE(painted().empty());
}

TEST_F(PaintTools, TheLassoTakesWhatLiesInside) {
  logic.tool = PaintTool::Lasso;
  startPainting();
  press(100, 80);
  for (const auto& [x, y] : {std::pair{220, 80}, {220, 160}, {100, 160}}) move(x, y);
  EXPECT_TRUE(painted().empty());
  release(100, 160);
  const Vector3d low = onPlane(100, 80), high = onPlane(220, 160);
  const double x0 = std::min(low.x(), high.x()), x1 = std::max(low.x(), high.x()),
               y0 = std::min(low.y(), high.y()), y1 = std::max(low.y(), high.y());
  const std::set<int> ids = painted();
  for (Index i = 0; i < document.preop()->size(); ++i) {
    const Vector3d p = document.preop()->points.row(i).transpose();
    // mm outside of the frame; within a pixel of it, 0.4 mm, either may be.
    const double outside = std::max({x0 - p.x(), p.x() - x1, y0 - p.y(), p.y() - y1});
    if (std::abs(outside) < 0.5) continue;
    EXPECT_EQ(ids.count(static_cast<int>(i)) == 1, outside < 0) << p.transpose();
  }
  key('z', "z");
  EXPECT_TRUE(painted().empty());
}

TEST_F(PaintTools, ALassoErasesWhereTheEraserIsOn) {
  startPainting();
  click(160, 120);
  logic.tool = PaintTool::Lasso;
  logic.label = patch::kNone;
  press(60, 40);
  for (const auto& [x, y] : {std::pair{260, 40}, {260, 200}, {60, 200}}) move(x, y);
  release(60, 200);
  EXPECT_TRUE(painted().empty());
}

TEST_F(PaintTools, FillTakesWhatABorderSurroundsAndRefusesWhatIsOpen) {
  logic.radiusMm = 4;
  startPainting();
  press(120, 80);
  for (const auto& [x, y] : {std::pair{200, 80}, {200, 160}, {120, 160}, {120, 80}}) move(x, y);
  release(120, 80);
  const std::size_t border = painted().size();
  logic.tool = PaintTool::Fill;
  click(60, 60);
  EXPECT_EQ(painted().size(), border);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("close the border"), std::string::npos);
  click(160, 120);
  EXPECT_GT(painted().size(), border);
  for (const auto& [x, y] : {std::pair{160, 120}, {140, 100}, {185, 145}}) {
    const Vector3d at = onPlane(x, y);
    EXPECT_THAT(within(2, at, at), testing::IsSubsetOf(painted()));
  }
}

TEST_F(PaintTools, PaintingWhatIsLockedOrHiddenWarns) {
  logic.setLocked(patch::kFalciform, true);
  startPainting();
  click(160, 120);
  EXPECT_TRUE(painted().empty());
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("locked"), std::string::npos);
  logic.setLocked(patch::kFalciform, false);
  SurfaceStyle hidden = presenter.style();
  hidden.hiddenPatches = {patch::kFalciform};
  presenter.setStyle(hidden);
  click(160, 120);
  EXPECT_FALSE(painted().empty()) << "painted all the same";
  EXPECT_NE(warnings.back().find("hidden"), std::string::npos);
  hidden.visible = false;
  presenter.setStyle(hidden);
  const auto before = painted();
  click(100, 90);
  EXPECT_EQ(painted(), before) << "a surface that is not seen is not painted";
  EXPECT_NE(warnings.back().find("surface is hidden"), std::string::npos);
}

}  // namespace falciform
