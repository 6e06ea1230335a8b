#pragma once
#include <memory>
#include <vector>

#include "Logic/Core/Case.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {

/// One change of labels: ids and their values before and after. Empty ids: nothing changed.
struct PatchEdit {
  std::vector<int> ids, before, after;
  [[nodiscard]] bool empty() const { return ids.empty(); }
};

/// What is painted: patches on one of the two surfaces of the case, or supports on the pre-operative one.
enum class PaintTarget { Preop, Scan, Supports };

/// The brush and its undo, without a window: the interactor hands over hits, the logic returns edits. Main
/// thread only. A stroke is one undo step; a stroke that changes nothing leaves none. At most 200 steps are
/// kept.
class PatchPaintingLogic {
 public:
  explicit PatchPaintingLogic(Case& document);
  ~PatchPaintingLogic();

  PaintTarget target = PaintTarget::Preop;
  int label = patch::kFalciform;  ///< of a patch, or of a support's region; 0 erases
  double radiusMm = 6.0;          ///< brush radius along the surface, in [0.5, 60]

  /// What is missing before anything can be painted ("Import or open a surface first."), or empty.
  [[nodiscard]] std::string missingInput() const;

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

  [[nodiscard]] bool canUndo() const;
  [[nodiscard]] bool canRedo() const;
  PatchEdit undo();
  PatchEdit redo();
  /// Removes a whole label; one undo step.
  PatchEdit clearPatch(int which);
  /// All labels of the target at once, as a template does; one undo step. Throws InputError for another
  /// number of labels than the surface has points.
  PatchEdit replaceLabels(const std::vector<int>& labels);

 private:
  struct State;
  Case& case_;
  std::unique_ptr<State> state_;
};

}  // namespace falciform
