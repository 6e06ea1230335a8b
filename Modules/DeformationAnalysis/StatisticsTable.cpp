#include "Modules/DeformationAnalysis/StatisticsTable.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <algorithm>
#include <cmath>

#include "Widgets/Forms/TableHeight.h"

namespace falciform {
namespace {

constexpr double kFontShare = 0.84;  // seven columns beside the view

const QString kThin(QChar(0x2009));  // thin space

QString percent(double share) {
  return std::isfinite(share) ? QString::number(100 * share, 'f', 0) + kThin + "%" : QString::fromUtf8("–");
}

QString figure(double value, int decimals) {
  return std::isfinite(value) ? QString::number(value, 'f', decimals) : QString::fromUtf8("–");
}

/// So many that the largest RMS has two digits: seven columns must find room beside the view.
int decimalsFor(const std::vector<RegionRow>& rows) {
  double largest = 0;
  for (const RegionRow& row : rows)
    if (std::isfinite(row.statistics.rms)) largest = std::max(largest, row.statistics.rms);
  return largest > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(largest))), 0, 6) : 1;
}

}  // namespace

StatisticsTable::StatisticsTable(QWidget* parent) : QTableWidget(0, 7, parent) {
  setObjectName("distanceStatistics");
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * kFontShare);
  setFont(small);
  horizontalHeader()->setFont(small);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  horizontalHeader()->setMinimumSectionSize(24);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  setSelectionMode(QAbstractItemView::NoSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setStyleSheet("QTableWidget::item { padding: 0 2px; } QHeaderView::section { padding: 1px 2px; }");
  auto* copyAll = new QAction(tr("Copy table"), this);
  copyAll->setObjectName("copyStatistics");
  copyAll->setShortcut(QKeySequence::Copy);
  copyAll->setShortcutContext(Qt::WidgetShortcut);
  connect(copyAll, &QAction::triggered, this, [this] { copy(); });
  addAction(copyAll);
  setContextMenuPolicy(Qt::ActionsContextMenu);
}

void StatisticsTable::addRow(const RegionRow& row, int decimals, const QString& unit) {
  const DistanceStatistics& s = row.statistics;
  const int at = rowCount();
  insertRow(at);
  const QString dash = QString::fromUtf8("–");
  const QString spread = std::isfinite(s.mean) ? figure(s.mean, decimals) + kThin + QString::fromUtf8("±") +
                                                     kThin + figure(s.sd, decimals)
                                               : dash;
  const int coarse = std::max(0, decimals - 1);  // the ends of a range are single places
  const QString range = std::isfinite(s.min) ? figure(s.min, coarse) + kThin + QString::fromUtf8("…") +
                                                   kThin + figure(s.max, coarse)
                                             : dash;
  const QStringList texts{QString::fromStdString(row.name),
                          percent(row.coverage),
                          spread,
                          figure(s.median, decimals),
                          range,
                          figure(s.rms, decimals),
                          figure(s.p95Absolute, decimals)};
  const auto fine = [&](double value) { return figure(value, decimals + 2); };
  const QString tip = tr("%1: %L2 covered places, mean %3, SD %4, median %5, from %6 to %7, RMS %8, P95 %9 ")
                          .arg(texts[0])
                          .arg(s.count)
                          .arg(fine(s.mean), fine(s.sd), fine(s.median), fine(s.min), fine(s.max),
                               fine(s.rms), fine(s.p95Absolute)) +
                      unit;
  for (int column = 0; column < columnCount(); ++column) {
    auto* item = new QTableWidgetItem(texts[column]);
    if (column > 0) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    item->setToolTip(tip);
    setItem(at, column, item);
  }
}

void StatisticsTable::show(const std::vector<RegionRow>& rows, const MapMetric& metric, const QString& what) {
  setRowCount(0);
  setVisible(!rows.empty());
  setHorizontalHeaderLabels(
      {what, tr("Cover"), tr("Mean\n± SD"), tr("Med."), tr("Range"), tr("RMS"), tr("P95")});
  const QString unit = QString::fromStdString(metric.unit);
  setToolTip(tr("%1%2 over the covered places.\nCover: share of the area that has a value. P95: of the size, "
                "either sign. Ctrl+C copies the table.")
                 .arg(QString::fromStdString(metric.title), unit.isEmpty() ? QString() : " in " + unit));
  const int decimals = decimalsFor(rows);
  for (const RegionRow& row : rows) addRow(row, decimals, unit);
  showAllRows(this);
}

QString StatisticsTable::tabbedText() const {
  QStringList lines, cells;
  for (int column = 0; column < columnCount(); ++column)
    if (horizontalHeaderItem(column)) cells << horizontalHeaderItem(column)->text().replace('\n', ' ');
  lines << cells.join('\t');
  for (int row = 0; row < rowCount(); ++row) {
    cells.clear();
    for (int column = 0; column < columnCount(); ++column) cells << item(row, column)->text();
    lines << cells.join('\t');
  }
  return lines.join('\n').replace(kThin, " ") + '\n';
}

void StatisticsTable::copy() const { QApplication::clipboard()->setText(tabbedText()); }

}  // namespace falciform
