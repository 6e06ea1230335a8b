#include "Widgets/Rendering/PaintInteractor.h"

#include <vtkCallbackCommand.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "Widgets/Rendering/BrushRing.h"
#include "Widgets/Rendering/SurfaceGeometry.h"

namespace falciform {

namespace {

constexpr double kSmallestBrushMm = 0.5, kLargestBrushMm = 60;
const Vector3d kEraserColour{0.95, 0.95, 0.95};

const VectorXd& costOf(const PatchPaintingLogic& logic) {
  static const VectorXd none;
  const auto cost = logic.pathCost();
  return cost ? *cost : none;  // the logic holds it
}

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
  path_ = std::make_unique<PathTool>(renderer);
  lasso_ = std::make_unique<LassoTool>(renderer);
}

void PaintInteractor::stopPainting() {
  if (!logic_) return;
  endStroke();
  logic_ = nullptr;
  presenter_ = nullptr;
  cursor_.reset();
  path_.reset();
  lasso_.reset();
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
  if (label == patch::kNone) return kEraserColour;
  const auto& own = presenter_->style().patchColours;
  const auto found = own.find(label);
  return found != own.end() ? found->second : patchColour(label);
}

void PaintInteractor::showCursor() {
  const int* at = Interactor->GetEventPosition();
  const auto place = placeAt(at[0], at[1]);
  if (place && logic_->tool == PaintTool::Line && !path_->empty() && logic_->surface() != nullptr)
    path_->hover(*logic_->surface(), tree(), {place->hit.triangle, place->hit.vertex, place->hit.point},
                 costOf(*logic_));
  path_->draw(presenter_->sceneFromSurface(), colourOf(logic_->label));
  const bool hasRing = logic_->tool == PaintTool::Brush || logic_->tool == PaintTool::Line;
  if (!place || !hasRing) {
    cursor_->hide();
    return;
  }
  const Points ring = picker_->tree() ? geodesicRing(*picker_->tree(), place->hit.triangle, place->hit.point,
                                                     logic_->radiusMm)
                                      : flatRing(place->hit.point, place->viewDirection, logic_->radiusMm);
  cursor_->show(transformed(ring, presenter_->sceneFromSurface()), colourOf(logic_->label));
}

void PaintInteractor::OnMouseMove() {
  if (!logic_ || State != VTKIS_NONE) {
    Superclass::OnMouseMove();
    return;
  }
  const int* at = Interactor->GetEventPosition();
  if (lasso_->running())
    lasso_->add(at[0], at[1]);
  else if (logic_->inStroke())
    paintTo(at[0], at[1]);
  showCursor();
  Interactor->Render();
}

bool PaintInteractor::mayPaint() {
  const auto warn = [&](const std::string& why) {
    if (onWarn) onWarn(why);
  };
  if (const std::string refusal = logic_->refusal(); !refusal.empty()) {
    warn(refusal);
    return false;
  }
  const SurfaceStyle& style = presenter_->style();
  if (!style.visible || style.opacity <= 0) {
    warn("The surface is hidden: tick it in the case tree to paint on it.");
    return false;
  }
  if (logic_->label != patch::kNone && style.hiddenPatches.contains(logic_->label))
    warn("The patch that you paint is hidden: tick it in the list of patches to see it.");
  return true;
}

void PaintInteractor::OnLeftButtonDown() {
  if (!logic_ || modifierHeld() || !logic_->missingInput().empty()) {
    Superclass::OnLeftButtonDown();
    return;
  }
  if (!mayPaint()) return;
  const int* at = Interactor->GetEventPosition();
  lastX_ = at[0];
  lastY_ = at[1];
  if (logic_->tool == PaintTool::Line) {
    clickPath();
  } else if (logic_->tool == PaintTool::Fill) {
    fillAt();
  } else {
    GrabFocus(EventCallbackCommand);
    if (logic_->tool == PaintTool::Lasso) {
      lasso_->add(lastX_, lastY_);
    } else {
      logic_->beginStroke();
      paintTo(lastX_, lastY_);
    }
  }
  showCursor();
  Interactor->Render();
}

// The first of the two clicks has set a corner here already.
void PaintInteractor::OnLeftButtonDoubleClick() {
  if (logic_ && logic_->tool == PaintTool::Line && !modifierHeld())
    finishPath();
  else
    OnLeftButtonDown();
}

void PaintInteractor::OnLeftButtonUp() {
  if (logic_ && (logic_->inStroke() || lasso_->running())) {
    ReleaseFocus();
    if (lasso_->running())
      finishLasso();
    else
      endStroke();
    Interactor->Render();
    return;
  }
  Superclass::OnLeftButtonUp();
}

void PaintInteractor::clickPath() {
  const auto place = placeAt(lastX_, lastY_);
  const BrushSurface* surface = logic_->surface();
  if (!place || surface == nullptr) return;
  if (!path_->click(*surface, tree(), {place->hit.triangle, place->hit.vertex, place->hit.point},
                    costOf(*logic_)) &&
      onWarn)
    onWarn("No way leads there: it is another piece of the surface.");
}

void PaintInteractor::finishPath() {
  if (path_->empty()) return;
  const BrushSurface* surface = logic_->surface();
  if (surface != nullptr) takeLabels(logic_->paint(pointsAlong(*surface, path_->line(), logic_->radiusMm)));
  path_->clear();
  changed();
}

void PaintInteractor::finishLasso() {
  const BrushSurface* surface = logic_->surface();
  if (surface != nullptr) {
    // Its tree may not be there yet, if the mouse has not touched the surface.
    (void)placeAt(lastX_, lastY_);
    takeLabels(logic_->paint(lasso_->inside(surface->shape(), tree(), presenter_->sceneFromSurface())));
  }
  lasso_->clear();
  changed();
}

void PaintInteractor::fillAt() {
  const auto place = placeAt(lastX_, lastY_);
  const BrushSurface* surface = logic_->surface();
  if (!place || surface == nullptr) return;
  const std::vector<int> region = regionAt(*surface, logic_->labels(), place->hit.vertex);
  if (const std::string problem = fillProblem(*surface, region); !problem.empty()) {
    if (onWarn) onWarn(problem);
    return;
  }
  // A click on another patch fills that patch: it means what it says.
  const bool replaced = std::exchange(logic_->replaces, true);
  takeLabels(logic_->paint(region));
  logic_->replaces = replaced;
  changed();
}

void PaintInteractor::OnMiddleButtonDown() {
  if (!logic_ || !(logic_->inStroke() || lasso_->running())) Superclass::OnMiddleButtonDown();
}

void PaintInteractor::OnRightButtonDown() {
  if (!logic_ || !(logic_->inStroke() || lasso_->running())) Superclass::OnRightButtonDown();
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
  if (!logic_) return;
  const std::string key = Interactor->GetKeySym() ? Interactor->GetKeySym() : "";
  if (!path_->empty() && (key == "Return" || key == "KP_Enter")) return finishPath();
  if (!path_->empty() && key == "BackSpace") {
    path_->back();
    return changed();
  }
  if (key != "Escape") return;
  if (!path_->empty() || lasso_->running()) {  // what is begun first, painting itself at the next
    path_->clear();
    lasso_->clear();
    return changed();
  }
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
  if (logic_->inStroke() || lasso_->running()) return;
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
