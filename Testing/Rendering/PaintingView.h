#pragma once
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>

#include "Testing/Support/SmallSurfaces.h"
#include "Widgets/Rendering/CameraViews.h"
#include "Widgets/Rendering/OffscreenWindow.h"
#include "Widgets/Rendering/PaintInteractor.h"
#include "Widgets/Rendering/Scene.h"

namespace falciform::test {

/// A flat 100 mm square with a vertex every 2 mm, seen from above, with mouse and keys.
struct PaintingView : testing::Test {
  PaintingView() {
    document.setPreop(std::make_shared<Surface>(grid(100, 50)));
    presenter.show(document.preop());
    window.show(scene);
    window.interactor()->SetInteractorStyle(style);
    style->SetDefaultRenderer(scene.renderer());
    fitView(scene.renderer(), document.preop()->points, directionOf(StandardView::Superior), 320.0 / 240);
    window.render();
  }
  ~PaintingView() override { style->stopPainting(); }

  void startPainting() { style->startPainting(logic, presenter, scene.renderer()); }

  void event(unsigned long id, int x, int y, bool shift = false, bool control = false) {
    window.interactor()->SetEventInformation(x, y, control, shift);
    window.interactor()->InvokeEvent(id);
  }
  void press(int x, int y, bool shift = false, bool control = false) {
    event(vtkCommand::LeftButtonPressEvent, x, y, shift, control);
  }
  void move(int x, int y, bool shift = false, bool control = false) {
    event(vtkCommand::MouseMoveEvent, x, y, shift, control);
  }
  void release(int x, int y) { event(vtkCommand::LeftButtonReleaseEvent, x, y); }
  void key(char code, const char* symbol) {
    window.interactor()->SetKeyEventInformation(0, 0, code, 0, symbol);
    window.interactor()->InvokeEvent(vtkCommand::KeyPressEvent);
    window.interactor()->InvokeEvent(vtkCommand::CharEvent);
  }

  /// Where the line of sight through a pixel meets the square's plane.
  [[nodiscard]] Vector3d onPlane(int x, int y) const {
    const PickRay ray = pickRay(scene.renderer(), x, y);
    return ray.origin - ray.origin.z() / ray.direction.z() * ray.direction;
  }
  [[nodiscard]] std::set<int> painted(int label = patch::kFalciform) const {
    const std::vector<int> ids = pointsOfPatch(*document.preop(), label);
    return {ids.begin(), ids.end()};
  }
  /// Vertices at most `radius` mm from the segment a-b.
  [[nodiscard]] std::set<int> within(double radius, const Vector3d& a, const Vector3d& b) const {
    std::set<int> ids;
    for (Index i = 0; i < document.preop()->size(); ++i) {
      const Vector3d p = document.preop()->points.row(i).transpose(), along = b - a;
      const double t =
          along.norm() > 0 ? std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0.0;
      if ((p - a - t * along).norm() <= radius) ids.insert(static_cast<int>(i));
    }
    return ids;
  }
  [[nodiscard]] Vector3d cameraPosition() const {
    Vector3d position;
    scene.renderer()->GetActiveCamera()->GetPosition(position.data());
    return position;
  }

  Case document;
  PatchPaintingLogic logic{document};
  Scene scene;
  SurfacePresenter& presenter = scene.add<SurfacePresenter>();
  OffscreenWindow window{320, 240};
  vtkNew<PaintInteractor> style;
};

}  // namespace falciform::test
