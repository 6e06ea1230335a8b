#include "Widgets/Rendering/PoseInteractor.h"

#include <gtest/gtest.h>

#include <numbers>

#include "Logic/Geometry/RigidSteps.h"
#include "Testing/Rendering/PaintingView.h"

namespace falciform {

namespace {

/// A body in the middle of the view, with handles of 25 mm, seen from above (+z towards the viewer).
struct HandlesTest : test::PaintingView {
  HandlesTest() {
    window.interactor()->SetInteractorStyle(mover);
    mover->SetDefaultRenderer(scene.renderer());
    mover->onMove = [this](const Isometry3d& now) {
      pose = now;
      ++moves;
    };
    mover->onLeave = [this] { left = true; };
    pose = shifted(test::randomMotion(3), -(test::randomMotion(3) * pivot));
    mover->setPose(pose);
    mover->startMoving(scene.renderer(), pivot, kRadius);
    first = pose;
    window.render();
  }
  ~HandlesTest() override { mover->stopMoving(); }

  [[nodiscard]] std::pair<int, int> pixel(const Vector3d& point) const {
    const Eigen::Vector2d at = screenPosition(scene.renderer(), point);
    return {static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))};
  }
  void dragFromTo(const Vector3d& from, const Vector3d& to, int steps = 20) {
    const auto [x, y] = pixel(from);
    press(x, y);
    for (int i = 1; i <= steps; ++i) {
      const auto [u, v] = pixel(from + (to - from) * i / steps);
      move(u, v);
    }
    const auto [u, v] = pixel(to);
    release(u, v);
  }
  [[nodiscard]] Eigen::AngleAxisd turn() const {
    return Eigen::AngleAxisd(pose.linear() * first.linear().transpose());
  }

  static constexpr double kRadius = 25;
  Vector3d pivot{4, 5, 6};  // in the body; the pose puts it at the scene's origin
  Isometry3d pose, first;
  int moves = 0;
  bool left = false;
  vtkNew<PoseInteractor> mover;
};

TEST_F(HandlesTest, AnArrowShiftsAlongItsAxisAsFarAsTheMouseGoes) {
  const Vector3d grip(kRadius * 1.3, 0, 0);
  dragFromTo(grip, grip + Vector3d(12, 7, 0));
  const Vector3d step = pose * pivot - first * pivot;
  const double pixelMm = mmPerPixel(scene.renderer(), grip);
  EXPECT_NEAR(step.x(), 12, 1.5 * pixelMm) << "mm; both ends are rounded to a pixel";
  EXPECT_LT(Eigen::Vector2d(step.y(), step.z()).norm(), 1e-9) << "and nowhere else";
  EXPECT_LT(turn().angle(), 1e-7);
}

TEST_F(HandlesTest, ARingTurnsAboutItsAxisByTheAngleOfTheMouseAndLeavesThePivot) {
  // Along a quarter of the ring that faces the viewer.
  const auto onRing = [](double angle) { return Vector3d(25 * std::cos(angle), 25 * std::sin(angle), 0); };
  const auto [x, y] = pixel(onRing(0.2));
  press(x, y);
  for (double angle = 0.2; angle <= 1.4; angle += 0.05) {
    const auto [u, v] = pixel(onRing(angle));
    move(u, v);
  }
  const auto [u, v] = pixel(onRing(1.4));
  move(u, v);
  release(u, v);
  EXPECT_NEAR(turn().angle(), 1.2, 0.05) << "rad; a pixel is 0.02 rad at this radius";
  EXPECT_NEAR(turn().axis().z(), 1, 1e-9);
  EXPECT_LT((pose * pivot - first * pivot).norm(), 1e-9);
}

TEST_F(HandlesTest, ARingSeenFromTheSideTurnsToo) {
  const Vector3d near(0, 0, kRadius);  // the point of the y ring that is nearest to the viewer
  dragFromTo(near + Vector3d(2, 0, 0), near + Vector3d(8, 0, 0));
  EXPECT_NEAR(std::abs(turn().axis().y()), 1, 1e-6);
  EXPECT_GT(turn().angle(), 0.1);
  EXPECT_GT((pose * (first.inverse() * Vector3d(0, 0, 1))).x(), 0) << "what faces the viewer goes right";
}

TEST_F(HandlesTest, BesideTheHandlesADragTurnsTheViewAndWithShiftItPans) {
  const Vector3d before = cameraPosition();
  press(20, 20);
  move(60, 40);
  release(60, 40);
  EXPECT_GT((cameraPosition() - before).norm(), 5);
  EXPECT_EQ(moves, 0);
  const auto [x, y] = pixel({kRadius * 1.3, 0, 0});
  press(x, y, true);
  move(x + 20, y, true);
  release(x + 20, y);
  EXPECT_EQ(moves, 0) << "any modifier navigates";
}

TEST_F(HandlesTest, ArrowKeysStepInTheDirectionsOfTheView) {
  mover->stepMm = 3;
  mover->stepDeg = 10;
  key(0, "Right");
  EXPECT_LT((pose * pivot - first * pivot - Vector3d(-3, 0, 0)).norm(), 1e-9)
      << "seen from the head, the patient's right is on the right";
  key(0, "Left");
  key(0, "Prior");
  EXPECT_LT((pose * pivot - first * pivot - Vector3d(0, 0, -3)).norm(), 1e-9) << "away from the viewer";
  key(0, "Next");
  EXPECT_TRUE(pose.isApprox(first, 1e-12));
  window.interactor()->SetKeyEventInformation(0, 1, 0, 0, "Prior");
  window.interactor()->InvokeEvent(vtkCommand::KeyPressEvent);
  EXPECT_NEAR(turn().angle(), 10 * std::numbers::pi / 180, 1e-9);
  EXPECT_LT((pose * pivot - first * pivot).norm(), 1e-9);
}

TEST_F(HandlesTest, EscLeavesAndTakesTheHandlesAway) {
  const RenderedImage with = window.image();
  key(27, "Escape");
  EXPECT_TRUE(left);
  EXPECT_FALSE(mover->moving());
  EXPECT_NE(window.image().rgb, with.rgb);
  dragFromTo({kRadius * 1.3, 0, 0}, {kRadius * 1.5, 0, 0});
  EXPECT_EQ(moves, 0);
}

TEST_F(HandlesTest, HandlesAreSeenThroughTheBodyTheyStandIn) {
  // Deep below the square, which would hide them.
  mover->setPose(shifted(pose, {0, 0, -60}));
  const RenderedImage image = window.image();
  int seen = 0;
  const Vector3d wanted = 255 * axisColour(2);
  for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3)
    seen += (Vector3d(image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]) - wanted).norm() < 12;
  EXPECT_GT(seen, 100) << "pixels of the ring about z";
}

}  // namespace

}  // namespace falciform
