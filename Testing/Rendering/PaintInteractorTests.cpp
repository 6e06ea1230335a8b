#include "Widgets/Rendering/PaintInteractor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Testing/Rendering/Baseline.h"
#include "Testing/Rendering/PaintingView.h"

namespace falciform {

using Painting = test::PaintingView;

TEST_F(Painting, AClickPaintsTheVerticesWithinTheBrush) {
  startPainting();
  logic.radiusMm = 11.3;
  press(140, 130);
  release(140, 130);
  const Vector3d hit = onPlane(140, 130);
  EXPECT_EQ(painted(), within(11.3, hit, hit));
  EXPECT_GT(painted().size(), 80u) << "11.3 mm around, one vertex in 4 mm^2";
}

TEST_F(Painting, OneFastMovePaintsTheWholeWayBetween) {
  startPainting();
  logic.radiusMm = 8;
  press(90, 80);
  move(230, 160);
  release(230, 160);
  const Vector3d from = onPlane(90, 80), to = onPlane(230, 160);
  // Dabs at most 0.4 radii apart leave notches of 2 % of the radius between them, and nothing lies beyond the
  // radius.
  EXPECT_THAT(within(8 * 0.975, from, to), testing::IsSubsetOf(painted()));
  EXPECT_THAT(painted(), testing::IsSubsetOf(within(8 + 1e-9, from, to)));
}

TEST_F(Painting, AStrokeIsOneUndoStepAndKeysUndoAndRedoIt) {
  startPainting();
  press(90, 80);
  move(150, 90);
  move(160, 150);
  release(160, 150);
  const auto stroke = painted();
  ASSERT_FALSE(stroke.empty());
  key('z', "z");
  EXPECT_TRUE(painted().empty());
  key('z', "z");
  EXPECT_TRUE(painted().empty()) << "nothing more to undo";
  key('y', "y");
  EXPECT_EQ(painted(), stroke);
}

TEST_F(Painting, DigitsPickThePatchAndZeroErases) {
  startPainting();
  key('2', "2");
  EXPECT_EQ(logic.label, patch::kInferiorRidge);
  press(160, 120);
  release(160, 120);
  EXPECT_FALSE(painted(patch::kInferiorRidge).empty());
  EXPECT_TRUE(painted(patch::kFalciform).empty());
  key('0', "0");
  press(160, 120);
  release(160, 120);
  EXPECT_TRUE(painted(patch::kInferiorRidge).empty());
}

TEST_F(Painting, KeysAndShiftWheelSizeTheBrushWithinItsLimits) {
  startPainting();
  logic.radiusMm = 10;
  key('+', "plus");
  EXPECT_DOUBLE_EQ(logic.radiusMm, 12);
  key('-', "minus");
  EXPECT_DOUBLE_EQ(logic.radiusMm, 9.6);
  event(vtkCommand::MouseWheelForwardEvent, 160, 120, true);
  EXPECT_DOUBLE_EQ(logic.radiusMm, 9.6 * 1.2);
  for (int i = 0; i < 40; ++i) event(vtkCommand::MouseWheelBackwardEvent, 160, 120, true);
  EXPECT_DOUBLE_EQ(logic.radiusMm, 0.5);
  for (int i = 0; i < 60; ++i) key('+', "plus");
  EXPECT_DOUBLE_EQ(logic.radiusMm, 60);
}

TEST_F(Painting, AnyModifierNavigatesInstead) {
  startPainting();
  for (const bool shift : {true, false}) {
    const Vector3d before = cameraPosition();
    press(120, 120, shift, !shift);
    move(150, 140, shift, !shift);
    release(150, 140);
    EXPECT_TRUE(painted().empty());
    if (shift) {
      EXPECT_GT((cameraPosition() - before).norm(), 1) << "Shift+left pans";
    }
  }
  const Vector3d before = cameraPosition();
  event(vtkCommand::MouseWheelForwardEvent, 160, 120);
  EXPECT_LT(cameraPosition().z(), before.z()) << "the wheel alone zooms";
}

TEST_F(Painting, EscapeLeavesAndKeepsTheRunningStroke) {
  startPainting();
  bool left = false;
  style->onLeave = [&] { left = true; };
  press(160, 120);
  key(27, "Escape");
  EXPECT_TRUE(left);
  EXPECT_FALSE(style->painting());
  EXPECT_FALSE(logic.inStroke());
  EXPECT_FALSE(painted().empty());
  const auto before = painted();
  release(160, 120);
  press(90, 80);
  move(120, 90);
  release(120, 90);
  EXPECT_EQ(painted(), before) << "the left button rotates again";
}

TEST_F(Painting, BesideTheSurfaceNothingIsPaintedAndNoUndoStepIsLeft) {
  startPainting();
  press(5, 5);
  move(8, 200);
  release(8, 200);
  EXPECT_FALSE(logic.canUndo());
}

TEST_F(Painting, PaintIsSeenAtOnceInThePatchColour) {
  startPainting();
  const RenderedImage clean = window.image();
  press(160, 120);
  const RenderedImage running = window.image();
  release(160, 120);
  move(5, 5);
  const auto isBlue = [](const std::array<int, 3>& c) { return c[2] > c[0] + 60 && c[2] > c[1] + 20; };
  EXPECT_FALSE(isBlue(clean.at(160, 239 - 120)));
  EXPECT_TRUE(isBlue(running.at(160, 239 - 120))) << "before the button is released";
  EXPECT_TRUE(isBlue(window.image().at(160, 239 - 120)));
}

TEST_F(Painting, TheRingFollowsTheMouseAndHidesBesideTheSurface) {
  startPainting();
  move(5, 5);
  const RenderedImage without = window.image();
  move(160, 120);
  const RenderedImage with = window.image();
  int changed = 0, farthest = 0;
  const double radiusPx = logic.radiusMm / mmPerPixel(scene.renderer(), onPlane(160, 120));
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; ++x)
      if (with.at(x, y) != without.at(x, y)) {
        ++changed;
        farthest = std::max(farthest, static_cast<int>(std::hypot(x - 160, 239 - y - 120)));
      }
  EXPECT_GT(changed, static_cast<int>(3 * radiusPx)) << "a ring of about 6 radii of pixels";
  EXPECT_NEAR(farthest, radiusPx, 5) << "pixels: half the line, its rim and the edge filter";
  move(5, 5);
  EXPECT_EQ(window.image().rgb, without.rgb);
}

TEST_F(Painting, AMovedDrawingIsPaintedWhereItIsSeen) {
  const Isometry3d motion = Isometry3d(Eigen::Translation3d(12, -7, 5));
  presenter.setSceneFromSurface(motion);
  startPainting();
  press(160, 120);
  release(160, 120);
  const PickRay ray = pickRay(scene.renderer(), 160, 120);
  const Vector3d inScene = ray.origin + (5 - ray.origin.z()) / ray.direction.z() * ray.direction;
  const Vector3d hit = motion.inverse() * inScene;
  EXPECT_EQ(painted(), within(logic.radiusMm, hit, hit));
}

}  // namespace falciform
