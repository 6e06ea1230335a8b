#include "Modules/DeformationAnalysis/StatisticsTable.h"

#include <QHeaderView>
#include <cmath>
#include <limits>

#include "Widgets/Forms/TableHeight.h"

namespace falciform {
namespace {

/// The values of one patch; label -1 takes all.
VectorXd valuesOf(const Surface& side, int label) {
  const auto found = side.arrays.find(kSignedDistance);
  if (found == side.arrays.end()) return {};
  std::vector<double> values;
  for (Index i = 0; i < side.size(); ++i)
    if (label < 0 || side.patchAt(i) == label) values.push_back(found->second[i]);
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

/// Share of the covered values whose size is at most `thresholdMm`; NaN if nothing is covered.
double shareWithin(const VectorXd& values, double thresholdMm) {
  int covered = 0, within = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    ++covered;
    if (std::abs(value) <= thresholdMm) ++within;
  }
  return covered > 0 ? static_cast<double>(within) / covered : std::numeric_limits<double>::quiet_NaN();
}

QString figure(double value, int decimals) {
  return std::isfinite(value) ? QString::number(value, 'f', decimals) : QString::fromUtf8("–");
}

}  // namespace

StatisticsTable::StatisticsTable(QWidget* parent) : QTableWidget(0, 5, parent) {
  setObjectName("distanceStatistics");
  setHorizontalHeaderLabels({tr("Side, mm"), tr("Mean"), tr("SD"), tr("95 %"), tr("within")});
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  setSelectionMode(QAbstractItemView::NoSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setToolTip(
      tr("Signed distance in mm over the covered places: mean, standard deviation, median, 95th percentile "
         "of the size,\n"
         "and the share of places whose distance is within the threshold"));
}

void StatisticsTable::addRow(const QString& name, const DistanceStatistics& statistics, double share) {
  const int row = rowCount();
  insertRow(row);
  auto* title = new QTableWidgetItem(name);
  title->setToolTip(tr("%L1 covered places, from %2 to %3 mm, median %5 mm, RMS %4 mm")
                        .arg(statistics.count)
                        .arg(figure(statistics.min, 2))
                        .arg(figure(statistics.max, 2))
                        .arg(figure(statistics.rms, 2), figure(statistics.median, 2)));
  setItem(row, 0, title);
  const QString within =
      std::isfinite(share) ? QString::number(100 * share, 'f', 0) + " %" : QString::fromUtf8("–");
  const QStringList values{figure(statistics.mean, 2), figure(statistics.sd, 2),
                           figure(statistics.p95Absolute, 2), within};
  for (int column = 1; column < columnCount(); ++column) {
    auto* item = new QTableWidgetItem(values[column - 1]);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setItem(row, column, item);
  }
}

void StatisticsTable::show(const DistanceMap* map, double thresholdMm) {
  setRowCount(0);
  setHorizontalHeaderItem(4, new QTableWidgetItem(tr("≤ %1 mm").arg(thresholdMm)));
  setVisible(map != nullptr);
  if (!map) return;
  addRow(tr("Liver, all"), map->preopAll, shareWithin(valuesOf(map->preop, -1), thresholdMm));
  for (const auto& [label, statistics] : map->preopByPatch)
    if (label > 0)
      addRow(tr("Liver, %1").arg(QString::fromStdString(patchName(map->preop, label))), statistics,
             shareWithin(valuesOf(map->preop, label), thresholdMm));
  addRow(tr("Scan, all"), map->scanAll, shareWithin(valuesOf(map->scan, -1), thresholdMm));
  for (const auto& [label, statistics] : map->scanByPatch)
    if (label > 0)
      addRow(tr("Scan, %1").arg(QString::fromStdString(patchName(map->scan, label))), statistics,
             shareWithin(valuesOf(map->scan, label), thresholdMm));
  showAllRows(this);
}

}  // namespace falciform
