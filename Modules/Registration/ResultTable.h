#pragma once
#include <QTableWidget>

#include "Logic/Core/Results.h"

namespace falciform {

/// The figures of a registration, a row each, in words and units. Everything here is fit, not target error.
class ResultTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit ResultTable(QWidget* parent = nullptr);

  /// `preop` gives the patches their names. nullptr empties the table.
  void show(const RegistrationResult* result, const Surface* preop);
  /// The value shown beside `name`, or an empty text.
  [[nodiscard]] QString value(const QString& name) const;

 private:
  void addFigure(const QString& name, const QString& value, const QString& meaning);
};

}  // namespace falciform
