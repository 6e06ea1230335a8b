#pragma once
#include <QWidget>

#include "Modules/Workbench.h"

class QPushButton;

namespace falciform {

class NumberBox;

/// The brush that mends what is marked on a scan: keep, remove, or "here is liver".
class ScanBrush : public QWidget {
  Q_OBJECT

 public:
  explicit ScanBrush(Workbench& workbench, QWidget* parent = nullptr);

  /// Controls follow brush and view; `ready`: there is a scan to paint on.
  void refresh(bool ready);

 Q_SIGNALS:
  /// A stroke was taken back or brought again.
  void changed();

 private:
  void choose(int label, bool on);

  Workbench& bench_;
  QPushButton *keep_, *remove_, *liver_, *undo_, *redo_;
  NumberBox* radius_;
};

}  // namespace falciform
