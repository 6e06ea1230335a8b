#pragma once
#include <QTableWidget>

#include "Logic/Core/Case.h"

namespace falciform {

/// The figures of a registration, a row each, in words and units: those of the fit, and below them, under a
/// heading of their own, what error is to be expected at targets.
class ResultTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit ResultTable(QWidget* parent = nullptr);

  /// The case's registration; patches and structures give rows their names. Hidden where there is none.
  void show(const Case& document);
  /// The value shown beside `name`, or an empty text.
  [[nodiscard]] QString value(const QString& name) const;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void addFigure(const QString& name, const QString& value, const QString& meaning);
  void addHeading(const QString& text, const QString& meaning);
  void addTargetErrors(const RegistrationResult& result, const Case& document);
};

}  // namespace falciform
