#pragma once
#include <QWidget>

#include "Modules/Workbench.h"

class QPushButton;
class QToolButton;

namespace falciform {

class NumberBox;

/// The brush on the supports: paint or erase, how wide, undo. What it paints is chosen elsewhere.
class SupportBrush : public QWidget {
  Q_OBJECT

 public:
  explicit SupportBrush(Workbench& workbench, QWidget* parent = nullptr);

  /// Controls follow brush, case and view; `label` is the region chosen.
  void refresh(int label);

 Q_SIGNALS:
  void changed();
  void newRegionWanted();

 private:
  Workbench& bench_;
  int label_ = 0;
  QPushButton *paint_, *undo_, *redo_, *clear_, *add_;
  QToolButton* erase_;
  NumberBox* radius_;
};

}  // namespace falciform
