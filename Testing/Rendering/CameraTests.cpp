#include <gtest/gtest.h>
#include <vtkCamera.h>

#include <memory>

#include "Testing/Support/SmallSurfaces.h"
#include "Widgets/Rendering/CameraViews.h"
#include "Widgets/Rendering/OffscreenWindow.h"
#include "Widgets/Rendering/Picking.h"
#include "Widgets/Rendering/Scene.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform {

namespace {

/// Where a point 40 mm from the centre towards the patient's left, posterior or superior is seen: pixels from
/// the middle.
Eigen::Vector2d seen(Scene& scene, const Vector3d& lps) {
  return screenPosition(scene.renderer(), 40 * lps) - screenPosition(scene.renderer(), Vector3d::Zero());
}

}  // namespace

TEST(StandardViews, ShowThePatientAsRadiologistsExpect) {
  const Vector3d left(1, 0, 0), posterior(0, 1, 0), superior(0, 0, 1);
  struct Expectation {
    StandardView view;
    Vector3d rightOfScreen, topOfScreen, towardsViewer;
  };
  const Expectation expectations[] = {{StandardView::Anterior, left, superior, -posterior},
                                      {StandardView::Posterior, -left, superior, posterior},
                                      {StandardView::Right, -posterior, superior, -left},
                                      {StandardView::Left, posterior, superior, left},
                                      {StandardView::Superior, -left, -posterior, superior},
                                      {StandardView::Inferior, left, -posterior, -superior}};
  Scene scene;
  scene.add<SurfacePresenter>().show(std::make_shared<Surface>(test::sphere(50, 3)));
  OffscreenWindow window(320, 240);
  window.show(scene);
  for (const auto& [view, rightOfScreen, topOfScreen, towardsViewer] : expectations) {
    setStandardView(scene.renderer(), view);
    window.render();
    const Eigen::Vector2d right = seen(scene, rightOfScreen), top = seen(scene, topOfScreen);
    EXPECT_GT(right.x(), 20) << static_cast<int>(view);
    EXPECT_NEAR(right.y(), 0, 0.01) << static_cast<int>(view);
    EXPECT_GT(top.y(), 20) << static_cast<int>(view);
    EXPECT_NEAR(top.x(), 0, 0.01) << static_cast<int>(view);
    Vector3d position;
    scene.renderer()->GetActiveCamera()->GetPosition(position.data());
    EXPECT_NEAR(position.normalized().dot(towardsViewer), 1, 1e-9) << static_cast<int>(view);
  }
}

TEST(StandardViews, FollowThePatientIntoAnotherFrame) {
  Scene scene;
  scene.add<SurfacePresenter>().show(std::make_shared<Surface>(test::sphere(50, 3)));
  OffscreenWindow window(320, 240);
  window.show(scene);
  const Matrix3d turn = test::randomMotion(5).linear();
  setStandardView(scene.renderer(), StandardView::Anterior, turn);
  window.render();
  EXPECT_GT(seen(scene, turn * Vector3d(1, 0, 0)).x(), 20);
  EXPECT_GT(seen(scene, turn * Vector3d(0, 0, 1)).y(), 20);
}

TEST(FitView, KeepsAllPointsInsideTheMarginsAndUsesTheRoom) {
  Points points = test::lumpyBody(3).points;
  points = transformed(points, test::randomMotion(3));
  Scene scene;
  OffscreenWindow window(400, 240);
  window.show(scene);
  const ViewMargins margins{0.1, 0.2, 0.05, 0.15};
  fitView(scene.renderer(), points, {Vector3d(1, 2, 3).normalized(), Vector3d(0, 0, 1)}, 400.0 / 240,
          margins);
  window.render();
  double left = 400, right = 0, bottom = 240, top = 0;
  for (Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector2d at = screenPosition(scene.renderer(), points.row(i).transpose());
    left = std::min(left, at.x());
    right = std::max(right, at.x());
    bottom = std::min(bottom, at.y());
    top = std::max(top, at.y());
  }
  // 2 pixels for the perspective's iteration.
  EXPECT_GE(left, 0.1 * 400 - 2);
  EXPECT_LE(right, 0.8 * 400 + 2);
  EXPECT_GE(bottom, 0.05 * 240 - 2);
  EXPECT_LE(top, 0.85 * 240 + 2);
  // One of the two directions is filled.
  EXPECT_GT(std::max((right - left) / (0.7 * 400), (top - bottom) / (0.8 * 240)), 0.97);
}

}  // namespace falciform
