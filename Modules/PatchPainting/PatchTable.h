#pragma once
#include <QTableWidget>

#include "Logic/Core/Surface.h"

namespace falciform {

/// What is painted on one surface: a row a patch with points, area, length and pieces.
class PatchTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit PatchTable(QWidget* parent = nullptr);

  /// nullptr empties it.
  void show(const std::shared_ptr<const Surface>& surface);

 private:
  std::shared_ptr<const Surface> shown_;
};

}  // namespace falciform
