#pragma once
#include "Modules/ModulePanel.h"

class QButtonGroup;
class QComboBox;
class QRadioButton;

namespace falciform {

class BrushControls;
class PatchTable;

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
  void setTarget(PaintTarget target);
  void applyArrangement();
  [[nodiscard]] std::shared_ptr<const Surface> targetSurface();

  QRadioButton *preop_, *scan_;
  BrushControls* brush_;
  QPushButton *paint_, *undo_, *redo_, *clear_, *transfer_;
  PatchTable* table_;
  QLabel *missing_, *warnings_;
  double transferRadiusMm_ = 3;
  Connection viewChanged_, brushChanged_;
};

}  // namespace falciform
