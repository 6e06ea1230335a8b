#include "Logic/Patches/PatchPaintingLogic.h"

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <optional>

#include "Logic/Core/Errors.h"
#include "Logic/Patches/BrushSurface.h"

namespace falciform {

namespace {

constexpr std::size_t kMaxSteps = 200;

/// One of the three layers of labels, on which surface it lies, and its undo.
struct Canvas {
  std::shared_ptr<const Surface> surface;  ///< the one in the case, for as long as nobody else sets another
  std::vector<int> labels;
  std::optional<BrushSurface> brush;  ///< made at the first stroke
  std::deque<PatchEdit> undo, redo;
  std::map<PathSnap, std::shared_ptr<const VectorXd>> costs;

  void take(const std::shared_ptr<const Surface>& newSurface, const std::vector<int>& newLabels) {
    surface = newSurface;
    labels = newLabels;
    if (surface) labels.resize(static_cast<std::size_t>(surface->size()), patch::kNone);
    undo.clear();
    redo.clear();
    if (brush && !(surface && brush->madeFrom(*surface))) brush.reset();
    costs.clear();
  }

  void assign(const std::vector<int>& ids, const std::vector<int>& values) {
    for (std::size_t i = 0; i < ids.size(); ++i) labels[static_cast<std::size_t>(ids[i])] = values[i];
  }

  void remember(PatchEdit step) {
    redo.clear();
    undo.push_back(std::move(step));
    if (undo.size() > kMaxSteps) undo.pop_front();
  }
};

std::vector<int> patchesOf(const std::shared_ptr<const Surface>& surface) {
  return surface ? surface->patch : std::vector<int>();
}

/// One label a point, free where the case has no supports yet.
std::vector<int> supportsOf(const Case& document) {
  if (!document.preop()) return {};
  std::vector<int> labels = document.supports() ? document.supports()->labels : std::vector<int>();
  labels.resize(static_cast<std::size_t>(document.preop()->size()), support_label::kFree);
  return labels;
}

/// The case's supports with other labels; whoever paints a label that has no region gets one.
std::shared_ptr<const SupportPainting> repainted(const Case& document, const std::vector<int>& labels) {
  SupportPainting painting =
      document.supports() ? *document.supports() : emptySupportPainting(document.preop()->size());
  painting.labels = labels;
  for (const int label : paintedSupports(painting))
    painting.regions.try_emplace(
        label, SupportRegion{"support " + std::to_string(label), SupportRegionKind::Fixed, 0});
  return std::make_shared<const SupportPainting>(std::move(painting));
}

bool sameButNames(const Surface& a, const Surface& b) {
  return a.points.rows() == b.points.rows() && a.triangles.rows() == b.triangles.rows() &&
         a.patch == b.patch && a.points == b.points && a.triangles == b.triangles;
}

PatchEdit reversed(const PatchEdit& edit) { return {edit.ids, edit.after, edit.before}; }

}  // namespace

struct PatchPaintingLogic::State {
  std::array<Canvas, 3> canvases;
  std::optional<PaintTarget> strokeOn;
  std::map<int, int> strokeBefore;  ///< of the running stroke: id, label before it
  std::set<int> locked;
  Connection watching;

  Canvas& of(PaintTarget which) { return canvases[static_cast<std::size_t>(which)]; }

  /// Another surface in the case: what was painted on the old one is history.
  void follow(PaintTarget which, const std::shared_ptr<const Surface>& inCase) {
    Canvas& canvas = of(which);
    if (inCase == canvas.surface) return;  // our own edit
    if (inCase && canvas.surface && sameButNames(*inCase, *canvas.surface)) {
      canvas.surface = inCase;  // a patch has got a name: no news to the brush
      return;
    }
    dropStroke(which);
    canvas.take(inCase, patchesOf(inCase));
  }

  /// Supports lie on the pre-operative surface, whose patches may be painted meanwhile, and their kinds and
  /// distances may be changed: no news to the brush as long as points and labels are the same.
  void followSupports(const Case& document) {
    Canvas& canvas = of(PaintTarget::Supports);
    const auto& preop = document.preop();
    const std::vector<int> labels = supportsOf(document);
    const bool sameShape = preop && canvas.surface && preop->points.rows() == canvas.surface->points.rows() &&
                           preop->points == canvas.surface->points;
    if (sameShape && (labels == canvas.labels || strokeOn == PaintTarget::Supports)) {
      canvas.surface = preop;
      return;
    }
    dropStroke(PaintTarget::Supports);
    canvas.take(preop, labels);
  }

  void dropStroke(PaintTarget which) {
    if (strokeOn != which) return;
    strokeOn.reset();
    strokeBefore.clear();
  }

  /// Puts the labels into the case as a new surface. The canvas takes it first, to know it again when the
  /// case announces it.
  void commit(PaintTarget which, Case& document) {
    if (which == PaintTarget::Supports) {
      document.setSupports(repainted(document, of(which).labels));
      return;
    }
    auto painted = std::make_shared<Surface>(*of(which).surface);
    painted->patch = of(which).labels;
    of(which).surface = painted;
    if (which == PaintTarget::Preop)
      document.setPreop(painted);
    else
      document.setScan(painted);
  }
};

PatchPaintingLogic::PatchPaintingLogic(Case& document) : case_(document), state_(std::make_unique<State>()) {
  state_->follow(PaintTarget::Preop, case_.preop());
  state_->follow(PaintTarget::Scan, case_.scan());
  state_->followSupports(case_);
  state_->watching = case_.changed.connect([this](Case::Part part) {
    if (part == Case::Part::Preop || part == Case::Part::Supports) state_->followSupports(case_);
    if (part == Case::Part::Preop) state_->follow(PaintTarget::Preop, case_.preop());
    if (part == Case::Part::Scan) state_->follow(PaintTarget::Scan, case_.scan());
  });
}

PatchPaintingLogic::~PatchPaintingLogic() = default;

std::string PatchPaintingLogic::missingInput() const {
  const Canvas& canvas = state_->of(target);
  if (canvas.surface && canvas.surface->size() > 0) return {};
  return target == PaintTarget::Scan ? "Open a scan first." : "Import or open a surface first.";
}

void PatchPaintingLogic::setLocked(int which, bool on) {
  if (on)
    state_->locked.insert(which);
  else
    state_->locked.erase(which);
}

const std::set<int>& PatchPaintingLogic::locked() const { return state_->locked; }

std::string PatchPaintingLogic::refusal() const {
  if (std::string missing = missingInput(); !missing.empty()) return missing;
  if (target == PaintTarget::Supports || label == patch::kNone || !state_->locked.contains(label)) return {};
  return "The patch '" + patchName(*state_->of(target).surface, label) +
         "' is locked: unlock it to paint it.";
}

int PatchPaintingLogic::painted(PaintTarget on, int current, int value) const {
  if (on == PaintTarget::Supports || current == value) return value;
  if (state_->locked.contains(current) || state_->locked.contains(value)) return current;
  const bool kept = current != patch::kNone && value != patch::kNone && !replaces;
  return kept ? current : value;
}

bool PatchPaintingLogic::touchesLocked(const PatchEdit& edit) const {
  if (target == PaintTarget::Supports || state_->locked.empty()) return false;
  const auto isLocked = [&](int value) { return state_->locked.contains(value); };
  return std::any_of(edit.before.begin(), edit.before.end(), isLocked) ||
         std::any_of(edit.after.begin(), edit.after.end(), isLocked);
}

const BrushSurface* PatchPaintingLogic::surface() {
  if (!missingInput().empty()) return nullptr;
  Canvas& canvas = state_->of(target);
  if (!canvas.brush) canvas.brush.emplace(*canvas.surface);
  return &*canvas.brush;
}

void PatchPaintingLogic::beginStroke() {
  if (inStroke()) endStroke();
  if (surface() == nullptr) return;
  state_->strokeOn = target;
}

PatchEdit PatchPaintingLogic::dab(int triangle, const Vector3d& hit, const Vector3d& viewDirection) {
  PatchEdit edit;
  if (!inStroke()) return edit;
  Canvas& canvas = state_->of(*state_->strokeOn);
  const double radius = std::clamp(radiusMm, 0.5, 60.0);
  const int value = std::clamp(label, patch::kNone, patch::kMax);
  for (const int id : canvas.brush->under(triangle, hit, viewDirection, radius)) {
    int& current = canvas.labels[static_cast<std::size_t>(id)];
    const int after = painted(*state_->strokeOn, current, value);
    if (current == after) continue;
    state_->strokeBefore.emplace(id, current);  // keeps the first value of the stroke
    edit.ids.push_back(id);
    edit.before.push_back(current);
    edit.after.push_back(after);
    current = after;
  }
  return edit;
}

PatchEdit PatchPaintingLogic::endStroke() {
  PatchEdit edit;
  if (!inStroke()) return edit;
  const PaintTarget on = *state_->strokeOn;
  Canvas& canvas = state_->of(on);
  for (const auto& [id, before] : state_->strokeBefore) {
    const int after = canvas.labels[static_cast<std::size_t>(id)];
    if (after == before) continue;
    edit.ids.push_back(id);
    edit.before.push_back(before);
    edit.after.push_back(after);
  }
  state_->strokeOn.reset();
  state_->strokeBefore.clear();
  if (edit.empty()) return edit;
  canvas.remember(edit);
  state_->commit(on, case_);
  return edit;
}

bool PatchPaintingLogic::inStroke() const { return state_->strokeOn.has_value(); }

const std::vector<int>& PatchPaintingLogic::labels() const { return state_->of(target).labels; }

bool PatchPaintingLogic::canUndo() const {
  const auto& steps = state_->of(target).undo;
  return !inStroke() && !steps.empty() && !touchesLocked(steps.back());
}

bool PatchPaintingLogic::canRedo() const {
  const auto& steps = state_->of(target).redo;
  return !inStroke() && !steps.empty() && !touchesLocked(steps.back());
}

PatchEdit PatchPaintingLogic::undo() {
  if (!canUndo()) return {};
  Canvas& canvas = state_->of(target);
  PatchEdit back = reversed(canvas.undo.back());
  canvas.redo.push_back(std::move(canvas.undo.back()));
  canvas.undo.pop_back();
  canvas.assign(back.ids, back.after);
  state_->commit(target, case_);
  return back;
}

PatchEdit PatchPaintingLogic::redo() {
  if (!canRedo()) return {};
  Canvas& canvas = state_->of(target);
  PatchEdit again = std::move(canvas.redo.back());
  canvas.redo.pop_back();
  canvas.undo.push_back(again);
  canvas.assign(again.ids, again.after);
  state_->commit(target, case_);
  return again;
}

void PatchPaintingLogic::setPathCost(const std::shared_ptr<const Surface>& of, PathSnap kind,
                                     std::shared_ptr<const VectorXd> cost) {
  for (Canvas& canvas : state_->canvases)
    // Painted meanwhile it is another Surface of the same shape.
    if (of && cost && canvas.surface && canvas.surface->points.rows() == of->points.rows() &&
        cost->size() == of->size() && canvas.surface->points == of->points)
      canvas.costs[kind] = cost;
}

std::shared_ptr<const VectorXd> PatchPaintingLogic::pathCost() const {
  const auto& costs = state_->of(target).costs;
  const auto found = costs.find(snap);
  return snap == PathSnap::None || found == costs.end() ? nullptr : found->second;
}

PatchEdit PatchPaintingLogic::paint(const std::vector<int>& ids) {
  std::vector<int> after = labels();
  const int value = std::clamp(label, patch::kNone, patch::kMax);
  for (const int id : ids) {
    int& current = after.at(static_cast<std::size_t>(id));
    current = painted(target, current, value);
  }
  return replaceLabels(after);
}

PatchEdit PatchPaintingLogic::apply(const PatchChange& change, int which) {
  std::vector<int> after = labels();
  for (const int id : change.gained) {
    int& current = after.at(static_cast<std::size_t>(id));
    current = painted(target, current, which);
  }
  for (const int id : change.lost) after.at(static_cast<std::size_t>(id)) = patch::kNone;
  return replaceLabels(after);
}

PatchEdit PatchPaintingLogic::clearPatch(int which) {
  if (which == patch::kNone) return {};
  std::vector<int> labels = state_->of(target).labels;
  std::replace(labels.begin(), labels.end(), which, patch::kNone);
  return replaceLabels(labels);
}

PatchEdit PatchPaintingLogic::replaceLabels(const std::vector<int>& labels) {
  PatchEdit edit;
  if (inStroke() || !missingInput().empty()) return edit;
  Canvas& canvas = state_->of(target);
  if (labels.size() != canvas.labels.size())
    throw InputError("there are " + std::to_string(labels.size()) + " labels for a surface of " +
                     std::to_string(canvas.labels.size()) + " points; take labels of the same surface");
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const bool kept = target != PaintTarget::Supports &&
                      (state_->locked.contains(canvas.labels[i]) || state_->locked.contains(labels[i]));
    if (canvas.labels[i] == labels[i] || kept) continue;
    edit.ids.push_back(static_cast<int>(i));
    edit.before.push_back(canvas.labels[i]);
    edit.after.push_back(labels[i]);
  }
  if (edit.empty()) return edit;
  canvas.assign(edit.ids, edit.after);
  canvas.remember(edit);
  state_->commit(target, case_);
  return edit;
}

}  // namespace falciform
