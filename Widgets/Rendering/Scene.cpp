#include "Widgets/Rendering/Scene.h"

#include <vtkLightKit.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkRendererCollection.h>

#include "Version.h"

namespace falciform {

void lightLikePaper(vtkRenderer* renderer) {
  vtkNew<vtkLightKit> kit;
  kit->SetKeyLightWarmth(0.5);
  kit->SetFillLightWarmth(0.5);
  kit->SetHeadLightWarmth(0.5);
  kit->SetBackLightWarmth(0.5);
  // The four together stay below 1 on any face: brighter light would wash the colours out.
  kit->SetKeyLightIntensity(0.74);
  kit->SetKeyLightAngle(35, 15);
  kit->SetKeyToFillRatio(2.5);
  kit->SetKeyToHeadRatio(2.5);
  kit->SetKeyToBackRatio(4);
  renderer->AutomaticLightCreationOff();
  kit->AddLightsToRenderer(renderer);
}

SceneStyle screenStyle(int textPx) {
  return {{0.80, 0.84, 0.89}, {0.95, 0.96, 0.98}, {0.10, 0.12, 0.15}, textPx};
}

Scene::Scene(const SceneStyle& style) : style_(style), renderer_(vtkSmartPointer<vtkRenderer>::New()) {
  renderer_->SetBackground(style.background.data());
  renderer_->SetBackground2(style.backgroundTop.data());
  renderer_->SetGradientBackground(style.background != style.backgroundTop);
  // Right order for see-through surfaces; without it the far side of a liver shines through its patches.
  renderer_->SetUseDepthPeeling(true);
  renderer_->SetMaximumNumberOfPeels(6);
  renderer_->SetOcclusionRatio(0.0);
  renderer_->SetUseFXAA(true);
  // VTK keeps this switch for all mappers in common: set once, a picture does not depend on what was drawn
  // before.
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  lightLikePaper(renderer_);
  notice_ = std::make_unique<TextPresenter>(renderer_.Get(), TextPlace::BottomLeft, style.textPx, style.text);
  notice_->setText(kResearchUse);
  cube_ = std::make_unique<OrientationCubePresenter>(renderer_.Get());
}

Scene::~Scene() {
  presenters_.clear();
  detach();
}

void Scene::setDark(bool dark) {
  const Vector3d bottom = dark ? Vector3d(0.50, 0.53, 0.57) : style_.background;
  const Vector3d top = dark ? Vector3d(0.66, 0.69, 0.72) : style_.backgroundTop;
  renderer_->SetBackground(bottom.x(), bottom.y(), bottom.z());
  renderer_->SetBackground2(top.x(), top.y(), top.z());
}

void Scene::attach(vtkRenderWindow* window) {
  detach();
  window_ = window;
  window->SetNumberOfLayers(2);
  // With multisampling, depth peeling draws see-through surfaces not at all (Mesa, VTK 9.1); FXAA smooths
  // edges instead.
  window->SetMultiSamples(0);
  window->AddRenderer(renderer_);
  window->AddRenderer(cube_->renderer());
}

void Scene::detach() {
  if (!window_) return;
  window_->RemoveRenderer(cube_->renderer());
  window_->RemoveRenderer(renderer_);
  window_ = nullptr;
}

}  // namespace falciform
