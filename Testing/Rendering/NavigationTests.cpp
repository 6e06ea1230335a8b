#include <gtest/gtest.h>
#include <vtkCallbackCommand.h>

#include "Testing/Rendering/PaintingView.h"

namespace falciform {

namespace {

struct Navigation : test::PaintingView {
  [[nodiscard]] Vector3d focus() const {
    Vector3d point;
    scene.renderer()->GetActiveCamera()->GetFocalPoint(point.data());
    return point;
  }
  [[nodiscard]] double distance() const { return scene.renderer()->GetActiveCamera()->GetDistance(); }
};

}  // namespace

TEST_F(Navigation, LeftRotatesAboutTheFocus) {
  const Vector3d before = cameraPosition(), centre = focus();
  const double far = distance();
  press(160, 120);
  move(200, 150);
  release(200, 150);
  EXPECT_GT((cameraPosition() - before).norm(), 10);
  EXPECT_LT((focus() - centre).norm(), 1e-9);
  EXPECT_NEAR(distance(), far, 1e-6);
  EXPECT_TRUE(painted().empty());
}

TEST_F(Navigation, MiddleAndShiftLeftPan) {
  for (const bool middle : {true, false}) {
    const Vector3d centre = focus();
    const double far = distance();
    event(middle ? vtkCommand::MiddleButtonPressEvent : vtkCommand::LeftButtonPressEvent, 160, 120, !middle);
    move(200, 150, !middle);
    event(middle ? vtkCommand::MiddleButtonReleaseEvent : vtkCommand::LeftButtonReleaseEvent, 200, 150);
    EXPECT_GT((focus() - centre).norm(), 5);
    EXPECT_NEAR(distance(), far, 1e-6);
  }
}

TEST_F(Navigation, RightAndWheelZoom) {
  const double far = distance();
  event(vtkCommand::RightButtonPressEvent, 160, 120);
  move(160, 160);
  event(vtkCommand::RightButtonReleaseEvent, 160, 160);
  EXPECT_NE(distance(), far);
  const double nearer = distance();
  event(vtkCommand::MouseWheelForwardEvent, 160, 120);
  EXPECT_LT(distance(), nearer);
}

TEST_F(Navigation, CapitalsAreTheStandardViews) {
  key('A', "A");
  EXPECT_LT(cameraPosition().y(), focus().y() - 50) << "anterior is -y";
  key('L', "L");
  EXPECT_GT(cameraPosition().x(), focus().x() + 50) << "left is +x";
  key('I', "I");
  EXPECT_LT(cameraPosition().z(), focus().z() - 50) << "inferior is -z";
}

TEST_F(Navigation, RFitsAllAgain) {
  scene.renderer()->GetActiveCamera()->Dolly(0.01);
  const double far = distance();
  key('r', "r");
  EXPECT_LT(distance(), far / 5);
}

TEST_F(Navigation, VtksOwnKeysDoNothing) {
  bool exited = false;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&exited);
  command->SetCallback(
      [](vtkObject*, unsigned long, void* flag, void*) { *static_cast<bool*>(flag) = true; });
  window.interactor()->AddObserver(vtkCommand::ExitEvent, command);
  const RenderedImage before = window.image();
  for (const char code : {'e', 'q', 'w', 's', '3', 'p', 'f', 'u'}) key(code, "");
  EXPECT_FALSE(exited);
  EXPECT_EQ(window.image().rgb, before.rgb);
}

}  // namespace falciform
