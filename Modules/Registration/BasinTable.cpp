#include "Modules/Registration/BasinTable.h"

#include <QHeaderView>
#include <QSignalBlocker>

#include "Widgets/Forms/TableHeight.h"

namespace falciform {

BasinTable::BasinTable(QWidget* parent) : QTableWidget(0, 5, parent) {
  setObjectName("basins");
  setHorizontalHeaderLabels({tr("Pose"), tr("Score"), tr("Starts"), tr("Turn, °"), tr("Shift, mm")});
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setToolTip(
      tr("Distinct poses that the search led to; select one to see the scan there.\n"
         "Score: robust residual and cost of bending, lower is better. Starts: how many led there.\n"
         "Turn in degrees and shift of the scan's middle in mm against the best"));
  connect(this, &QTableWidget::itemSelectionChanged, this, [this] { Q_EMIT choiceChanged(chosen()); });
}

int BasinTable::chosen() const {
  const QModelIndexList rows = selectionModel()->selectedRows();
  return rows.isEmpty() ? -1 : rows.front().row();
}

void BasinTable::choose(int row) {
  const QSignalBlocker quiet(this);
  selectRow(row);
}

void BasinTable::show(const RegistrationResult* result, const Surface* scan, std::size_t best,
                      std::size_t used) {
  const QSignalBlocker quiet(this);
  clearSelection();
  setRowCount(0);
  if (result && scan && scan->size() > 0) {
    const Vector3d middle = scan->points.colwise().mean();
    for (std::size_t i = 0; i < result->basins.size(); ++i) {
      const RegistrationBasin& basin = result->basins[i];
      const Isometry3d change = basin.scanFromPreop * result->basins[best].scanFromPreop.inverse();
      const double turn = Eigen::AngleAxisd(change.linear()).angle() * 180 / EIGEN_PI;
      const QStringList cells{
          i == best ? tr("%1 (best)").arg(i + 1) : QString::number(i + 1),
          QString::number(basin.score, 'f', 3),
          QString::number(basin.starts),
          QString::number(turn, 'f', 1),
          QString::number((change * middle - middle).norm(), 'f', 1),
      };
      const int row = rowCount();
      insertRow(row);
      for (int column = 0; column < cells.size(); ++column) {
        auto* item = new QTableWidgetItem(cells[column]);
        if (column > 0) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        QFont font = item->font();
        font.setBold(i == used);
        item->setFont(font);
        setItem(row, column, item);
      }
    }
  }
  showAllRows(this);
}

}  // namespace falciform
