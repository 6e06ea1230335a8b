#include "Modules/AtlasUpdate/TargetTable.h"

#include <QHeaderView>
#include <algorithm>

#include "Widgets/Forms/TableHeight.h"

namespace falciform {
namespace {

QString place(const Vector3d& mm) {
  return QString("%1, %2, %3").arg(mm.x(), 0, 'f', 0).arg(mm.y(), 0, 'f', 0).arg(mm.z(), 0, 'f', 0);
}

QString figure(const std::optional<double>& mm) {
  return mm ? QString::number(*mm, 'f', 1) : QString::fromUtf8("–");
}

}  // namespace

TargetTable::TargetTable(QWidget* parent) : QTableWidget(0, 5, parent) {
  setObjectName("targetTable");
  setHorizontalHeaderLabels(
      {tr("Target"), tr("Before"), tr("Now"), tr("Expected\nerror, mm"), tr("True\nerror, mm")});
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  verticalHeader()->hide();
  verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  setSelectionMode(QAbstractItemView::NoSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setWordWrap(true);
  setToolTip(tr(
      "Before: x, y, z in the CT's frame, mm. Now: in the scan's frame, mm. Expected error: the update's own "
      "estimate (root mean square), mm. True error: where true places are loaded, mm."));
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
          {QString::fromStdString(target.name), place(target.before), place(target.now),
           figure(target.expectedErrorMm), figure(target.trueErrorMm)},
          tr("%1%2. Rigid registration: %3 mm in the scan's frame%4")
              .arg(QString::fromStdString(target.name), target.structure ? tr(" (its middle)") : QString(),
                   place(target.rigid),
                   target.rigidErrorMm ? tr(", %1 mm off").arg(*target.rigidErrorMm, 0, 'f', 1) : QString()));
  } else {
    for (const Landmark& target : document.targets().points)
      addRow({QString::fromStdString(target.name), place(target.position), dash, dash, dash},
             tr("Update the model to see where it is now"));
    for (const auto& [name, structure] : document.structures())
      if (structure->size() > 0)
        addRow({QString::fromStdString(name), place(structure->points.colwise().mean().transpose()), dash,
                dash, dash},
               tr("The middle of this structure. Update the model to see where it is now"));
  }
  const bool truth = made && std::any_of(made->targets.begin(), made->targets.end(),
                                         [](const UpdatedTarget& target) { return target.trueErrorMm; });
  setColumnHidden(4, !truth);
  setVisible(rowCount() > 0);
  showAllRows(this);
}

}  // namespace falciform
