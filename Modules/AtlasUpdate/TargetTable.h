#pragma once
#include <QTableWidget>

#include "Logic/Atlas/UpdatedCase.h"

namespace falciform {

/// Targets and structures, a row each: where they were, where they are now, how far that may be off, and,
/// where the truth is known, how far it is off.
class TargetTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit TargetTable(QWidget* parent = nullptr);

  /// nullptr lists the case's targets and structures as they were.
  void show(const UpdatedCase* made, const Case& document);

 private:
  void addRow(const QStringList& texts, const QString& tip);
};

}  // namespace falciform
