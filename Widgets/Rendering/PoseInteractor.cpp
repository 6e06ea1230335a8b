#include "Widgets/Rendering/PoseInteractor.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <cmath>
#include <numbers>
#include <string>

#include "Logic/Geometry/RigidSteps.h"
#include "Widgets/Rendering/Picking.h"

namespace falciform {

vtkStandardNewMacro(PoseInteractor);

void PoseInteractor::startMoving(vtkRenderer* renderer, const Vector3d& pivotInBody, double radiusMm) {
  stopMoving();
  renderer_ = renderer;
  pivotInBody_ = pivotInBody;
  radiusMm_ = radiusMm;
  handles_ = std::make_unique<PoseHandlesPresenter>(renderer, pixelRatio);
  setPose(pose_);
}

void PoseInteractor::stopMoving() {
  grip_.reset();
  handles_.reset();
}

void PoseInteractor::setPose(const Isometry3d& sceneFromBody) {
  pose_ = sceneFromBody;
  if (!handles_) return;
  handles_->show(pose_ * pivotInBody_, radiusMm_);
  renderer_->ResetCameraClippingRange();
}

void PoseInteractor::OnLeftButtonDown() {
  const int* at = Interactor->GetEventPosition();
  if (handles_ && !modifierHeld()) grip_ = handles_->at(at[0], at[1]);
  if (!grip_) return Superclass::OnLeftButtonDown();
  GrabFocus(EventCallbackCommand);
  lastX_ = at[0];
  lastY_ = at[1];
}

void PoseInteractor::OnLeftButtonUp() {
  if (!grip_) return Superclass::OnLeftButtonUp();
  grip_.reset();
  ReleaseFocus();
}

void PoseInteractor::OnMouseMove() {
  if (!handles_ || State != VTKIS_NONE) return Superclass::OnMouseMove();
  const int* at = Interactor->GetEventPosition();
  if (grip_) {
    dragTo(at[0], at[1]);
  } else {
    const std::optional<PoseGrip> under = handles_->at(at[0], at[1]);
    handles_->highlight(under ? std::optional(under->handle) : std::nullopt);
  }
  Interactor->Render();
}

// The held point follows the mouse as far as its arrow or ring lets it.
void PoseInteractor::dragTo(int x, int y) {
  const Eigen::Vector2d mouse(x - lastX_, y - lastY_);
  lastX_ = x;
  lastY_ = y;
  const Vector3d axis = Vector3d::Unit(grip_->handle.axis), pivot = pose_ * pivotInBody_;
  const bool turns = grip_->handle.turns;
  const Vector3d way = turns ? Vector3d(axis.cross(grip_->point - pivot)) : axis;  // mm per rad, or per mm
  const double unit = 1 / way.norm();  // a step of 1 mm, so that perspective does not bend it
  const Eigen::Vector2d shown =
      (screenPosition(renderer_, grip_->point + unit * way) - screenPosition(renderer_, grip_->point)) / unit;
  // An arrow or a stretch of ring that points at the viewer cannot be followed: a pixel would mean metres.
  if (shown.norm() * unit < 0.1) return;
  const double amount = mouse.dot(shown) / shown.squaredNorm();
  if (turns)
    grip_->point = pivot + Eigen::AngleAxisd(amount, axis) * (grip_->point - pivot);
  else
    grip_->point += amount * axis;
  moveBy(axis, amount, turns);
}

void PoseInteractor::moveBy(const Vector3d& axis, double amount, bool turns) {
  setPose(turns ? turned(pose_, pivotInBody_, axis, amount) : shifted(pose_, amount * axis));
  if (onMove) onMove(pose_);
}

void PoseInteractor::OnKeyPress() {
  if (!handles_) return;
  const std::string key = Interactor->GetKeySym() ? Interactor->GetKeySym() : "";
  if (key == "Escape") {
    stopMoving();
    if (onLeave) onLeave();
    Interactor->Render();
    return;
  }
  Vector3d up, ahead;
  renderer_->GetActiveCamera()->GetDirectionOfProjection(ahead.data());
  renderer_->GetActiveCamera()->GetViewUp(up.data());
  const Vector3d right = ahead.cross(up).normalized();
  up = right.cross(ahead).normalized();
  // Right, up and away as shifts. As turns: the face that is seen goes right or up, or turns clockwise.
  struct Key {
    const char *more, *less;
    Vector3d shift, turn;
  };
  const Key keys[]{{"Right", "Left", right, up}, {"Up", "Down", up, -right}, {"Prior", "Next", ahead, ahead}};
  const bool turns = Interactor->GetShiftKey() != 0;
  for (const Key& one : keys) {
    if (key != one.more && key != one.less) continue;
    const double sign = key == one.more ? 1 : -1;
    moveBy(turns ? one.turn : one.shift, sign * (turns ? stepDeg * std::numbers::pi / 180 : stepMm), turns);
    Interactor->Render();
  }
}

}  // namespace falciform
