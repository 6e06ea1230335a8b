#include "Widgets/Rendering/OrientationCubePresenter.h"

#include <vtkAnnotatedCubeActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkProperty.h>

namespace falciform {

namespace {

constexpr double kLeft = 0.86, kHeight = 0.18;  // shares of the view

vtkSmartPointer<vtkAnnotatedCubeActor> patientCube() {
  auto cube = vtkSmartPointer<vtkAnnotatedCubeActor>::New();
  // LPS: x grows to the patient's left, y to posterior, z to superior.
  cube->SetXPlusFaceText("L");
  cube->SetXMinusFaceText("R");
  cube->SetYPlusFaceText("P");
  cube->SetYMinusFaceText("A");
  cube->SetZPlusFaceText("S");
  cube->SetZMinusFaceText("I");
  // Letters upright when the patient stands upright.
  cube->SetXFaceTextRotation(0);
  cube->SetYFaceTextRotation(0);
  cube->SetZFaceTextRotation(-90);
  cube->SetFaceTextScale(0.6);
  cube->GetCubeProperty()->SetColor(0.93, 0.93, 0.93);
  cube->GetTextEdgesProperty()->SetColor(0.2, 0.2, 0.2);
  cube->GetTextEdgesProperty()->SetLineWidth(1);
  // One tint per axis, distinct for the colour blind.
  const auto tint = [](vtkProperty* plus, vtkProperty* minus, double r, double g, double b) {
    for (vtkProperty* p : {plus, minus}) {
      p->SetColor(r, g, b);
      p->SetAmbient(0.6);
      p->SetDiffuse(0.4);
    }
  };
  tint(cube->GetXPlusFaceProperty(), cube->GetXMinusFaceProperty(), 0.75, 0.27, 0.0);
  tint(cube->GetYPlusFaceProperty(), cube->GetYMinusFaceProperty(), 0.0, 0.35, 0.6);
  tint(cube->GetZPlusFaceProperty(), cube->GetZMinusFaceProperty(), 0.0, 0.45, 0.33);
  return cube;
}

}  // namespace

OrientationCubePresenter::OrientationCubePresenter(vtkRenderer* view)
    : view_(view), cube_(vtkSmartPointer<vtkRenderer>::New()), actor_(patientCube()) {
  cube_->SetLayer(1);
  cube_->InteractiveOff();
  setBottom(0);
  cube_->AddViewProp(actor_);
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
    static_cast<OrientationCubePresenter*>(self)->follow();
  });
  observer_ = view_->AddObserver(vtkCommand::StartEvent, command);
}

OrientationCubePresenter::~OrientationCubePresenter() { view_->RemoveObserver(observer_); }

void OrientationCubePresenter::setSceneFromLps(const Matrix3d& rotation) { sceneFromLps_ = rotation; }

void OrientationCubePresenter::setBottom(double share) {
  cube_->SetViewport(kLeft, share, 1.0, share + kHeight);
}

void OrientationCubePresenter::setVisible(bool visible) { actor_->SetVisibility(visible); }

void OrientationCubePresenter::follow() {
  vtkCamera* seen = view_->GetActiveCamera();
  Vector3d direction, up;
  seen->GetDirectionOfProjection(direction.data());
  seen->GetViewUp(up.data());
  direction = sceneFromLps_.transpose() * direction;
  up = sceneFromLps_.transpose() * up;
  vtkCamera* camera = cube_->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(-5 * direction.x(), -5 * direction.y(), -5 * direction.z());
  camera->SetViewUp(up.data());
  camera->SetViewAngle(22);
  cube_->ResetCameraClippingRange();
}

}  // namespace falciform
