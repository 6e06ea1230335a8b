#pragma once
#include <QWidget>

#include "Logic/Patches/PatchPaintingLogic.h"

class QButtonGroup;
class QComboBox;
class QLabel;

namespace falciform {

class NumberBox;

/// The tool, what it does to what is there, how wide it is. Writes PatchPaintingLogic's public settings.
class BrushControls : public QWidget {
  Q_OBJECT

 public:
  explicit BrushControls(PatchPaintingLogic& painting, QWidget* parent = nullptr);

  /// Controls follow the logic: mouse and keys may have changed it. `chosen` is the patch to return to after
  /// erasing.
  void refresh(int chosen);

 Q_SIGNALS:
  void changed();

 private:
  void apply();

  PatchPaintingLogic& painting_;
  int chosen_ = patch::kFalciform;
  QButtonGroup *tools_, *modes_;
  NumberBox* radius_;
  QComboBox* snap_;
  QLabel* hint_;
};

}  // namespace falciform
