#pragma once
#include "Modules/ModulePanel.h"

class QRadioButton;

namespace falciform {

class BrushControls;
class PatchList;
class PatchOperations;
class SuggestionBox;

/// Which surface is painted, with which brush; undo; what is painted; patches taken over from another
/// surface.
class PatchPaintingPanel : public ModulePanel {
  Q_OBJECT

 public:
  explicit PatchPaintingPanel(Workbench& workbench, QWidget* parent = nullptr);

  void enter() override;
  void leave() override;
  /// Lays the patches of a painted surface file onto the chosen surface, as a job.
  void transferFrom(const QString& file);

 protected:
  void refresh() override;

 private:
  void addTarget();
  void addTools();
  void addTransfer();
  void addPatches();
  void setTarget(PaintTarget target);
  /// What a line snaps to is measured once for each surface and kind.
  void measureCrests();
  void choosePatch(int label);
  void applyArrangement();
  [[nodiscard]] std::shared_ptr<const Surface> targetSurface();

  QRadioButton *preop_, *scan_;
  BrushControls* brush_;
  QPushButton *paint_, *undo_, *redo_, *clear_, *newPatch_, *colour_, *transfer_;
  int chosen_ = patch::kFalciform;  ///< the marked patch, also while erasing
  PatchList* list_;
  PatchOperations* operations_;
  SuggestionBox* suggestions_;
  QLabel *missing_, *warnings_;
  PaintTool tool_ = PaintTool::Brush;  ///< of this step, while another one is on screen
  bool replaces_ = false;
  double transferRadiusMm_ = 3;
  Connection viewChanged_, brushChanged_;
};

}  // namespace falciform
