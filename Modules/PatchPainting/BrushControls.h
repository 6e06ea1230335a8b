#pragma once
#include <QWidget>

#include "Logic/Core/Case.h"
#include "Logic/Patches/PatchPaintingLogic.h"

class QComboBox;
class QPushButton;
class QToolButton;

namespace falciform {

class NumberBox;

/// The brush: which patch, add or erase, how wide. Writes PatchPaintingLogic's public settings.
class BrushControls : public QWidget {
  Q_OBJECT

 public:
  BrushControls(PatchPaintingLogic& painting, Case& document, QWidget* parent = nullptr);

  /// Controls follow the logic (the mouse may have changed the radius) and the target's patch names.
  void refresh();
  /// The patch chosen in the list, also while erasing.
  [[nodiscard]] int chosenPatch() const;

 Q_SIGNALS:
  void changed();

 private:
  void addNamedPatch(const QString& name);
  void apply();

  PatchPaintingLogic& painting_;
  Case& case_;
  QComboBox* patch_;
  QPushButton* newPatch_;
  QToolButton *add_, *erase_;
  NumberBox* radius_;
};

}  // namespace falciform
