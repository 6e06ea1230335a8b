#pragma once
#include <QWidget>

#include "Modules/Workbench.h"

class QPushButton;

namespace falciform {

/// What is done to a whole patch at once: grow, shrink, smooth, fill its holes, keep its largest piece. Each
/// is one undo step.
class PatchOperations : public QWidget {
  Q_OBJECT

 public:
  explicit PatchOperations(Workbench& bench, QWidget* parent = nullptr);

  /// Enabled where the patch `chosen` can be changed.
  void refresh(int chosen);

 Q_SIGNALS:
  void changed();

 private:
  void add(const char* name, const QString& text, const QString& tip,
           std::function<PatchChange(const BrushSurface&, const std::vector<int>&)> operation);

  Workbench& bench_;
  int chosen_ = patch::kFalciform;
  double mm_ = 2;
  std::vector<QPushButton*> buttons_;
};

}  // namespace falciform
