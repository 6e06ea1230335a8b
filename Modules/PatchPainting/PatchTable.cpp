#include "Modules/PatchPainting/PatchTable.h"

#include <QHeaderView>

#include "Logic/Patches/PatchStatistics.h"
#include "Widgets/Forms/TableHeight.h"
#include "Widgets/Rendering/PatchColours.h"

namespace falciform {

PatchTable::PatchTable(QWidget* parent) : QTableWidget(0, 5, parent) {
  setObjectName("patchTable");
  setHorizontalHeaderLabels({tr("Patch"), tr("Points"), tr("mm²"), tr("Length"), tr("Pieces")});
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  verticalHeader()->hide();
  setSelectionMode(QAbstractItemView::NoSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
  showAllRows(this);
  setToolTip(
      tr("What is painted on the chosen surface: points, area in mm², length in mm along its longest axis,\n"
         "number of separate pieces"));
}

void PatchTable::show(const std::shared_ptr<const Surface>& surface) {
  if (surface == shown_) return;
  shown_ = surface;
  const std::vector<PatchStatistics> rows =
      surface ? patchStatistics(*surface) : std::vector<PatchStatistics>{};
  setRowCount(static_cast<int>(rows.size()));
  for (int row = 0; row < rowCount(); ++row) {
    const PatchStatistics& patch = rows[static_cast<std::size_t>(row)];
    const Vector3d rgb = patchColour(patch.label);
    QPixmap swatch(12, 12);
    swatch.fill(QColor::fromRgbF(rgb.x(), rgb.y(), rgb.z()));
    setItem(row, 0, new QTableWidgetItem(QIcon(swatch), QString::fromStdString(patch.name)));
    const QString area =
        surface->triangles.rows() > 0 ? QString::number(patch.areaMm2, 'f', 0) : QString::fromUtf8("–");
    const QStringList numbers{QString("%L1").arg(patch.points), area,
                              tr("%1 mm").arg(patch.lengthMm, 0, 'f', 0), QString::number(patch.pieces)};
    for (int column = 1; column < columnCount(); ++column) {
      auto* item = new QTableWidgetItem(numbers[column - 1]);
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      setItem(row, column, item);
    }
  }
  showAllRows(this);
}

}  // namespace falciform
