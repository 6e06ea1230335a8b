#pragma once
#include <QTableWidget>

#include "Logic/Atlas/UpdatedCase.h"

namespace falciform {

/// Targets and structures, a row each: how far the update moves them, how far that may be off, and, where the
/// truth is known, how far update and rigid registration are off. Where they are stands in the tooltips.
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
