#include "Modules/AtlasUpdate/TargetTable.h"

#include <QHeaderView>
#include <algorithm>

#include "Widgets/Forms/TableHeight.h"

namespace falciform {
namespace {

QString place(const Vector3d& mm) {
  return QString("%1, %2, %3").arg(mm.x(), 0, 'f', 0).arg(mm.y(), 0, 'f', 0).arg(mm.z(), 0, 'f', 0);
}

enum Column { kName, kMoved, kExpected, kTrueError, kRigidError };

QString figure(const std::optional<double>& mm) {
  return mm ? QString::number(*mm, 'f', 1) : QString::fromUtf8("–");
}

}  // namespace

TargetTable::TargetTable(QWidget* parent) : QTableWidget(0, 5, parent) {
  setObjectName("targetTable");
  setHorizontalHeaderLabels(
      {tr("Target"), tr("Moved\nby"), tr("Expected\nerror"), tr("True\nerror"), tr("Rigid's\nerror")});
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  verticalHeader()->hide();
  verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  setSelectionMode(QAbstractItemView::NoSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setWordWrap(true);
  setToolTip(
      tr("All in mm. Moved by: from where the rigid registration puts it to where the update does. Expected "
         "error: the update's own estimate (root mean square). True error: where true places are loaded, of "
         "the update; beside it that of the rigid registration."));
}

void TargetTable::addRow(const QStringList& texts, const QString& tip) {
  const int row = rowCount();
  insertRow(row);
  for (int column = 0; column < texts.size(); ++column) {
    auto* item = new QTableWidgetItem(texts[column]);
    item->setToolTip(tip);
    if (column > 0) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setItem(row, column, item);
  }
}

void TargetTable::show(const UpdatedCase* made, const Case& document) {
  setRowCount(0);
  const QString dash = QString::fromUtf8("–");
  if (made) {
    for (const UpdatedTarget& target : made->targets)
      addRow(
          {QString::fromStdString(target.name), figure((target.now - target.rigid).norm()),
           figure(target.expectedErrorMm), figure(target.trueErrorMm), figure(target.rigidErrorMm)},
          tr("%1%2, mm\nin the CT: %3\nin the scan, by the rigid registration: %4\nin the scan, as updated: "
             "%5")
              .arg(QString::fromStdString(target.name), target.structure ? tr(" (its middle)") : QString(),
                   place(target.before), place(target.rigid), place(target.now)));
  } else {
    for (const Landmark& target : document.targets().points)
      addRow({QString::fromStdString(target.name), dash, dash, dash, dash},
             tr("In the CT at %1 mm. Update the model to see where it is now").arg(place(target.position)));
    for (const auto& [name, structure] : document.structures())
      if (structure->size() > 0)
        addRow({QString::fromStdString(name), dash, dash, dash, dash},
               tr("Its middle is in the CT at %1 mm. Update the model to see where it is now")
                   .arg(place(structure->points.colwise().mean().transpose())));
  }
  const bool truth = made && std::any_of(made->targets.begin(), made->targets.end(),
                                         [](const UpdatedTarget& target) { return target.trueErrorMm; });
  setColumnHidden(kTrueError, !truth);
  setColumnHidden(kRigidError, !truth);
  setVisible(rowCount() > 0);
  showAllRows(this);
}

}  // namespace falciform
