#include "Widgets/Rendering/NavigationInteractor.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <optional>

#include "Widgets/Rendering/CameraViews.h"

namespace falciform {

namespace {

std::optional<StandardView> viewOfKey(char key) {
  switch (key) {
    case 'A':
      return StandardView::Anterior;
    case 'P':
      return StandardView::Posterior;
    case 'R':
      return StandardView::Right;
    case 'L':
      return StandardView::Left;
    case 'S':
      return StandardView::Superior;
    case 'I':
      return StandardView::Inferior;
    default:
      return std::nullopt;
  }
}

}  // namespace

vtkStandardNewMacro(NavigationInteractor);

// VTK's own keys are left out on purpose: they would quit the program (e, q) or draw wire frames (w).
void NavigationInteractor::OnChar() { navigate(Interactor->GetKeyCode()); }

bool NavigationInteractor::navigate(char key) {
  const std::optional<StandardView> view = viewOfKey(key);
  if (key != 'r' && !view) return false;
  const int* at = Interactor->GetEventPosition();
  FindPokedRenderer(at[0], at[1]);
  if (CurrentRenderer && view)
    setStandardView(CurrentRenderer, *view, sceneFromLps);
  else if (CurrentRenderer)
    CurrentRenderer->ResetCamera();
  Interactor->Render();
  return true;
}

bool NavigationInteractor::modifierHeld() const {
  return Interactor->GetShiftKey() || Interactor->GetControlKey() || Interactor->GetAltKey();
}

}  // namespace falciform
