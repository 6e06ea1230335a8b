#pragma once
#include <QTableWidget>

#include "Modules/DeformationAnalysis/RegionRows.h"

namespace falciform {

/// Values by region, or by case: a row each, in the metric's unit. Ctrl+C copies all of it for a spreadsheet.
class StatisticsTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit StatisticsTable(QWidget* parent = nullptr);

  /// `what` heads the first column; no rows hides the table.
  void show(const std::vector<RegionRow>& rows, const MapMetric& metric, const QString& what);
  /// Head and rows, cells parted by tabs.
  [[nodiscard]] QString tabbedText() const;
  void copy() const;

 private:
  void addRow(const RegionRow& row, int decimals, const QString& unit);
};

}  // namespace falciform
