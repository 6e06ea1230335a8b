#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "Widgets/Rendering/NavigationInteractor.h"
#include "Widgets/Rendering/PoseHandlesPresenter.h"

namespace falciform {

/// Moves a body by hand. Left drag on a ring turns it about its pivot, on an arrow shifts it along; arrow
/// keys and Page Up/Down shift it by a step in the directions of the view, with Shift they turn it; Esc
/// leaves. All else navigates.
class PoseInteractor : public NavigationInteractor {
 public:
  static PoseInteractor* New();
  vtkTypeMacro(PoseInteractor, NavigationInteractor);
  PoseInteractor(const PoseInteractor&) = delete;
  PoseInteractor& operator=(const PoseInteractor&) = delete;

  /// `pivotInBody` mm is what turns leave in place; the handles stand around it.
  void startMoving(vtkRenderer* renderer, const Vector3d& pivotInBody, double radiusMm);
  void stopMoving();
  [[nodiscard]] bool moving() const { return handles_ != nullptr; }
  /// Where the body is; draws the handles there.
  void setPose(const Isometry3d& sceneFromBody);

  double pixelRatio = 1;                          ///< as PoseHandlesPresenter's; before startMoving
  double stepMm = 5, stepDeg = 5;                 ///< of a key
  std::function<void(const Isometry3d&)> onMove;  ///< the new pose, scene from body
  std::function<void()> onLeave;                  ///< left by Esc

  void OnMouseMove() override;
  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnKeyPress() override;

 protected:
  PoseInteractor() = default;
  ~PoseInteractor() override = default;

 private:
  void dragTo(int x, int y);
  void moveBy(const Vector3d& axis, double amount, bool turns);

  vtkRenderer* renderer_ = nullptr;
  std::unique_ptr<PoseHandlesPresenter> handles_;
  std::optional<PoseGrip> grip_;  ///< held now
  Vector3d pivotInBody_ = Vector3d::Zero();
  double radiusMm_ = 0;
  Isometry3d pose_ = Isometry3d::Identity();
  int lastX_ = 0, lastY_ = 0;
};

}  // namespace falciform
