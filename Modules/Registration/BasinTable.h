#pragma once
#include <QTableWidget>

#include "Logic/Core/Results.h"
#include "Logic/Core/Surface.h"

namespace falciform {

/// The distinct poses that a registration found, a row each, as they stand in the result.
class BasinTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit BasinTable(QWidget* parent = nullptr);

  /// Motion is given against `best`; the pose at `used` is marked as the result's. nullptr empties the table.
  void show(const RegistrationResult* result, const Surface* scan, std::size_t best, std::size_t used);
  /// Row that is selected, or -1.
  [[nodiscard]] int chosen() const;
  /// Selects a row without announcing it.
  void choose(int row);

 Q_SIGNALS:
  /// The user selected a row, or none (-1).
  void choiceChanged(int row);
};

}  // namespace falciform
