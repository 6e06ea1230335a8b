#pragma once
#include <QTableWidget>

#include "Logic/Core/Results.h"

namespace falciform {

/// Distances by side and patch: a row each, mm.
class StatisticsTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit StatisticsTable(QWidget* parent = nullptr);

  /// nullptr empties it. `thresholdMm` is that of the last column.
  void show(const DistanceMap* map, double thresholdMm);

 private:
  void addRow(const QString& name, const DistanceStatistics& statistics, double shareWithinThreshold);
};

}  // namespace falciform
