#pragma once
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "Logic/Core/Case.h"
#include "Logic/Patches/PatchPath.h"
#include "Logic/Patches/PatchShapes.h"

namespace falciform {

/// One change of labels: ids and their values before and after. Empty ids: nothing changed.
struct PatchEdit {
  std::vector<int> ids, before, after;
  [[nodiscard]] bool empty() const { return ids.empty(); }
};

/// What is painted: patches on one of the two surfaces of the case, or supports on the pre-operative one.
enum class PaintTarget { Preop, Scan, Supports };

/// What a line is drawn to.
enum class PathSnap { None, Ridge, Groove };

/// What the mouse does: paints where it is dragged, lays a line from click to click, goes around what is to
/// be painted, or fills what it clicks.
enum class PaintTool { Brush, Line, Lasso, Fill };

/// The brush and its undo, without a window: the interactor hands over hits, the logic returns edits. Main
/// thread only. A stroke is one undo step; a stroke that changes nothing leaves none. At most 200 steps are
/// kept.
class PatchPaintingLogic {
 public:
  explicit PatchPaintingLogic(Case& document);
  ~PatchPaintingLogic();

  PaintTarget target = PaintTarget::Preop;
  PaintTool tool = PaintTool::Brush;
  PathSnap snap = PathSnap::None;  ///< of the line tool; wants setPathCost()
  int label = patch::kFalciform;   ///< of a patch, or of a support's region; 0 erases
  bool replaces = false;           ///< patches: paints over others too; else where nothing is painted
  double radiusMm = 6.0;           ///< brush radius along the surface, in [0.5, 60]

  /// What is missing before anything can be painted ("Import or open a surface first."), or empty.
  [[nodiscard]] std::string missingInput() const;

  /// Whatever is painted, undone or taken over: points of a locked patch keep it, on both surfaces, and no
  /// others get it. Supports know no locks.
  void setLocked(int which, bool on);
  [[nodiscard]] const std::set<int>& locked() const;
  /// Why the brush as it is would paint nothing, in plain words; empty if it would.
  [[nodiscard]] std::string refusal() const;

  /// A stroke: begin, any number of dabs, end. `viewDirection` (towards the scene, in the surface's frame)
  /// keeps the brush on faces that look at the camera; zero takes all. `triangle` -1: nearest point of a
  /// cloud. Returns what this dab changed, for live drawing.
  void beginStroke();
  PatchEdit dab(int triangle, const Vector3d& hit, const Vector3d& viewDirection = Vector3d::Zero());
  /// Writes the stroke into the Case (a new Surface or SupportPainting) and returns it whole.
  PatchEdit endStroke();
  [[nodiscard]] bool inStroke() const;
  /// Labels as they stand, the running stroke included.
  [[nodiscard]] const std::vector<int>& labels() const;

  /// There is a step, and it touches no locked patch.
  [[nodiscard]] bool canUndo() const;
  [[nodiscard]] bool canRedo() const;
  PatchEdit undo();
  PatchEdit redo();
  /// The target's surface as the brush knows it, for the operations of PatchShapes.h and PatchPath.h; made
  /// when first asked for. nullptr while input is missing.
  [[nodiscard]] const BrushSurface* surface();
  /// What a step costs at each point of `of` for a line that snaps (crestCost()); forgotten when another
  /// surface comes. Ignored if `of` is no longer in the case.
  void setPathCost(const std::shared_ptr<const Surface>& of, PathSnap kind,
                   std::shared_ptr<const VectorXd> cost);
  /// For `snap` on the target's surface; nullptr where there is nothing to snap to, or not yet.
  [[nodiscard]] std::shared_ptr<const VectorXd> pathCost() const;
  /// Paints these points as the brush would; one undo step.
  PatchEdit paint(const std::vector<int>& ids);
  /// What an operation says of the patch `which`: it gains as the brush would paint; one undo step.
  PatchEdit apply(const PatchChange& change, int which);
  /// Removes a whole label; one undo step.
  PatchEdit clearPatch(int which);
  /// All labels of the target at once, as a template does; one undo step. Throws InputError for another
  /// number of labels than the surface has points.
  PatchEdit replaceLabels(const std::vector<int>& labels);

 private:
  /// What `point` becomes if painted with `value`.
  [[nodiscard]] int painted(PaintTarget on, int current, int value) const;
  [[nodiscard]] bool touchesLocked(const PatchEdit& edit) const;

  struct State;
  Case& case_;
  std::unique_ptr<State> state_;
};

}  // namespace falciform
