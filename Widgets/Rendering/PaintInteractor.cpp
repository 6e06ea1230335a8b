#include "Widgets/Rendering/PaintInteractor.h"

#include <vtkCallbackCommand.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "Widgets/Rendering/BrushRing.h"
#include "Widgets/Rendering/SurfaceGeometry.h"

namespace falciform {

namespace {

constexpr double kSmallestBrushMm = 0.5, kLargestBrushMm = 60;
const Vector3d kEraserColour{0.95, 0.95, 0.95};

}  // namespace

vtkStandardNewMacro(PaintInteractor);

PaintInteractor::PaintInteractor() = default;
PaintInteractor::~PaintInteractor() = default;

void PaintInteractor::startPainting(PatchPaintingLogic& logic, SurfacePresenter& presenter,
                                    vtkRenderer* renderer) {
  stopPainting();
  logic_ = &logic;
  presenter_ = &presenter;
  renderer_ = renderer;
  cursor_ = std::make_unique<BrushCursorPresenter>(renderer);
}

void PaintInteractor::stopPainting() {
  if (!logic_) return;
  endStroke();
  logic_ = nullptr;
  presenter_ = nullptr;
  cursor_.reset();
  picker_.reset();
  picked_.reset();
}

std::optional<PaintInteractor::Place> PaintInteractor::placeAt(double x, double y) {
  const auto surface = presenter_->surface();
  if (!surface || surface->size() == 0) return std::nullopt;
  // Each stroke makes a new Surface with the old geometry: the search tree still holds then.
  if (surface != picked_) {
    if (!picker_ || !sameGeometry(*surface, *picker_->surface()))
      picker_ = std::make_unique<SurfacePicker>(surface);
    picked_ = surface;
  }
  const Isometry3d surfaceFromScene = presenter_->sceneFromSurface().inverse();
  PickRay ray = pickRay(renderer_, x, y);
  ray = {surfaceFromScene * ray.origin, surfaceFromScene.linear() * ray.direction};
  const auto hit = picker_->pick(ray);
  if (!hit) return std::nullopt;
  return Place{*hit, ray.direction};
}

void PaintInteractor::paintTo(int x, int y) {
  // Dabs overlap by more than half, however fast the mouse moves.
  double stepPx = 4;
  if (const auto place = placeAt(x, y))
    stepPx = std::max(1.0, 0.4 * logic_->radiusMm /
                               mmPerPixel(renderer_, presenter_->sceneFromSurface() * place->hit.point));
  const double length = std::hypot(x - lastX_, y - lastY_);
  const int steps = std::max(1, static_cast<int>(std::ceil(length / stepPx)));
  for (int step = 1; step <= steps; ++step) {
    const double share = static_cast<double>(step) / steps;
    if (const auto place = placeAt(lastX_ + share * (x - lastX_), lastY_ + share * (y - lastY_)))
      takeLabels(logic_->dab(place->hit.triangle, place->hit.point, place->viewDirection));
  }
  lastX_ = x;
  lastY_ = y;
}

void PaintInteractor::takeLabels(const PatchEdit& edit) {
  if (edit.empty()) return;
  std::vector<int> values;
  values.reserve(edit.ids.size());
  for (const int id : edit.ids) values.push_back(logic_->labels()[static_cast<std::size_t>(id)]);
  presenter_->setPatchLabels(edit.ids, values);
}

Vector3d PaintInteractor::colourOf(int label) const {
  const auto& own = presenter_->style().patchColours;
  const auto found = own.find(label);
  return found != own.end() ? found->second : patchColour(label);
}

void PaintInteractor::showCursor() {
  const int* at = Interactor->GetEventPosition();
  const auto place = placeAt(at[0], at[1]);
  if (!place) {
    cursor_->hide();
    return;
  }
  const Points ring = picker_->tree() ? geodesicRing(*picker_->tree(), place->hit.triangle, place->hit.point,
                                                     logic_->radiusMm)
                                      : flatRing(place->hit.point, place->viewDirection, logic_->radiusMm);
  cursor_->show(transformed(ring, presenter_->sceneFromSurface()),
                logic_->label == patch::kNone ? kEraserColour : colourOf(logic_->label));
}

void PaintInteractor::OnMouseMove() {
  if (!logic_ || State != VTKIS_NONE) {
    Superclass::OnMouseMove();
    return;
  }
  const int* at = Interactor->GetEventPosition();
  if (logic_->inStroke()) paintTo(at[0], at[1]);
  showCursor();
  Interactor->Render();
}

void PaintInteractor::OnLeftButtonDown() {
  if (!logic_ || modifierHeld() || !logic_->missingInput().empty()) {
    Superclass::OnLeftButtonDown();
    return;
  }
  GrabFocus(EventCallbackCommand);
  const int* at = Interactor->GetEventPosition();
  lastX_ = at[0];
  lastY_ = at[1];
  logic_->beginStroke();
  paintTo(lastX_, lastY_);
  showCursor();
  Interactor->Render();
}

void PaintInteractor::OnLeftButtonUp() {
  if (logic_ && logic_->inStroke()) {
    ReleaseFocus();
    endStroke();
    Interactor->Render();
    return;
  }
  Superclass::OnLeftButtonUp();
}

void PaintInteractor::OnMiddleButtonDown() {
  if (!logic_ || !logic_->inStroke()) Superclass::OnMiddleButtonDown();
}

void PaintInteractor::OnRightButtonDown() {
  if (!logic_ || !logic_->inStroke()) Superclass::OnRightButtonDown();
}

void PaintInteractor::OnMouseWheelForward() {
  if (logic_ && Interactor->GetShiftKey())
    scaleBrush(1.2);
  else
    Superclass::OnMouseWheelForward();
}

void PaintInteractor::OnMouseWheelBackward() {
  if (logic_ && Interactor->GetShiftKey())
    scaleBrush(0.8);
  else
    Superclass::OnMouseWheelBackward();
}

void PaintInteractor::OnLeave() {
  if (!logic_ || logic_->inStroke()) return;
  cursor_->hide();
  Interactor->Render();
}

void PaintInteractor::OnKeyPress() {
  if (!logic_ || std::string(Interactor->GetKeySym() ? Interactor->GetKeySym() : "") != "Escape") return;
  stopPainting();
  if (onLeave) onLeave();
  Interactor->Render();
}

void PaintInteractor::OnChar() {
  const char key = Interactor->GetKeyCode();
  if (!navigate(key) && logic_) paintKey(key);
}

void PaintInteractor::paintKey(char key) {
  if (key == '+' || key == '=') return scaleBrush(1.2);
  if (key == '-') return scaleBrush(0.8);
  // The patch stays the same for a whole stroke, and a running stroke is not undone.
  if (logic_->inStroke()) return;
  if (key >= '0' && key <= '9') {
    logic_->label = key - '0';
  } else if (key == 'z' && logic_->canUndo()) {
    takeLabels(logic_->undo());
  } else if (key == 'y' && logic_->canRedo()) {
    takeLabels(logic_->redo());
  } else {
    return;
  }
  changed();
}

void PaintInteractor::scaleBrush(double factor) {
  logic_->radiusMm = std::clamp(logic_->radiusMm * factor, kSmallestBrushMm, kLargestBrushMm);
  changed();
}

void PaintInteractor::endStroke() {
  if (!logic_->inStroke()) return;
  if (!logic_->endStroke().empty() && onChange) onChange();
}

void PaintInteractor::changed() {
  showCursor();
  if (onChange) onChange();
  Interactor->Render();
}

}  // namespace falciform
